#include "grader/testing/call_history.h"

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace muelle::grader {

namespace {

using Numbers = CallHistoryBase::Numbers;

/// What no answer agrees with, where what is asked throws.
template <class Ask>
Numbers predicted(const Ask& ask) {
  try {
    return ask();
  } catch (const std::logic_error&) {
    return {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()};
  }
}

bool answers(const CallHistoryBase& history, const UntypedArguments& arguments) {
  try {
    history.askOracle(arguments);
    return true;
  } catch (const std::logic_error&) {
    return false;
  }
}

}  // namespace

std::map<std::string, std::unique_ptr<CallHistoryBase>>& CallHistoryBase::all() {
  static std::map<std::string, std::unique_ptr<CallHistoryBase>> histories;
  return histories;
}

void CallHistoryBase::add(UntypedArguments given, Numbers outcome) {
  if (calls_.size() >= room_ || numbers_ + outcome.size() > mostNumbers) return;
  numbers_ += outcome.size();
  calls_.push_back({std::move(given), std::move(outcome)});
}

std::vector<ArgumentItem> CallHistoryBase::items(std::size_t call) const {
  std::vector<ArgumentItem> items;
  int index = 0;
  for (const Argument& each : calls_[call].given.list) each.kind->appendItems(items, each.value, {index++, -1, -1});
  return items;
}

double CallHistoryBase::roundOff(std::size_t call) const {
  Numbers numbers;
  for (const Argument& each : calls_[call].given.list) each.kind->appendNumbers(numbers, each.value);
  return 1e-12 * scaleOf(numbers);
}

/// The argument of that index, or nullptr.
const Argument* CallHistoryBase::at(const UntypedArguments& arguments, int index) const {
  return index >= 0 && index < argumentCount() ? &arguments.list[static_cast<std::size_t>(index)] : nullptr;
}

bool CallHistoryBase::areAlike(int i, int j) const {
  const Argument *first = at(none_, i), *second = at(none_, j);
  return first != nullptr && second != nullptr && first->kind == second->kind;
}

UntypedArguments CallHistoryBase::changed(std::size_t call, int index,
                                          const std::function<void(const Argument&)>& change) const {
  UntypedArguments arguments = copyOf(call);
  if (const Argument* argument = at(arguments, index)) change(*argument);
  return arguments;
}

Numbers CallHistoryBase::oracleTo(const UntypedArguments& arguments) const {
  return predicted([&] { return askOracle(arguments); });
}

Numbers CallHistoryBase::oracleWith(std::size_t call, const Leaf& leaf, const Change& change) const {
  return oracleTo(changed(call, leaf.argument, [&](const Argument& a) { a.kind->changeAt(a.value, leaf, change); }));
}

Numbers CallHistoryBase::oracleOfPart(std::size_t call, int which, Part part) const {
  return oracleTo(changed(call, which, [&](const Argument& a) { a.kind->keepPart(a.value, part); }));
}

Numbers CallHistoryBase::oracleWithFirstForAll(std::size_t call, const Leaf& leaf) const {
  return oracleTo(changed(call, leaf.argument, [&](const Argument& a) { a.kind->takeFirstForAll(a.value, leaf); }));
}

Numbers CallHistoryBase::oracleSwapped(std::size_t call, int i, int j) const {
  const UntypedArguments arguments = copyOf(call);
  if (areAlike(i, j)) at(arguments, i)->kind->swap(at(arguments, i)->value, at(arguments, j)->value);
  return oracleTo(arguments);
}

Numbers CallHistoryBase::oracleWithTwice(std::size_t call, int i, int j) const {
  const UntypedArguments arguments = copyOf(call);
  if (areAlike(i, j)) at(arguments, j)->kind->assign(at(arguments, j)->value, at(arguments, i)->value);
  return oracleTo(arguments);
}

Numbers CallHistoryBase::listed(std::size_t mistake, std::size_t call) const {
  return predicted([&] { return askListed(mistake, calls_[call].given); });
}

void CallHistoryBase::ask(std::size_t call, const Edit& edit) {
  const UntypedArguments arguments = changed(call, edit.leaf.argument, [&edit](const Argument& a) {
    if (edit.change) {
      a.kind->changeAt(a.value, edit.leaf, edit.change);
    } else {
      a.kind->keepPart(a.value, edit.part);
    }
  });
  if (!canAskSubmission() || (hasOracle() && !answers(*this, arguments))) return;
  room_ = std::max(mostCalls, calls_.size() + 1);  // a motion may have taken all
  askSubmission(arguments);
}

void CallHistoryBase::keepOnly(std::size_t calls) {
  for (; calls_.size() > calls; calls_.pop_back()) numbers_ -= calls_.back().outcome.size();
}

}  // namespace muelle::grader
