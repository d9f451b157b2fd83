#include "grader/testing/asked_afresh.h"

#include "grader/remote/fault.h"
#include "grader/remote/session.h"
#include "grader/testing/generic_mistakes.h"

#include <cstring>
#include <set>
#include <vector>

namespace muelle::grader {

namespace {

using Numbers = CallHistoryBase::Numbers;

/// NaN, too, is the same as itself.
bool areSameBits(const Numbers& a, const Numbers& b) {
  return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0);
}

/// The first, the middle and the last wrong call: each costs a process.
std::set<std::size_t> someWrongCalls(const CallHistoryBase& history) {
  std::vector<std::size_t> wrong;
  for (std::size_t call = 0; call < history.calls(); ++call) {
    if (!agree(history.outcome(call), history.oracle(call), history.roundOff(call))) wrong.push_back(call);
  }
  if (wrong.empty()) return {};
  return {wrong.front(), wrong[wrong.size() / 2], wrong.back()};
}

bool answersOtherwise(CallHistoryBase& history, std::size_t call) {
  const std::size_t asked = history.calls();
  Session::current().startAfresh();
  history.ask(call, {{}, [](double number) { return number; }});
  const bool isOther = history.calls() > asked && !areSameBits(history.outcome(asked), history.outcome(call));
  history.keepOnly(asked);
  return isOther;
}

}  // namespace

bool answersOtherwiseAfresh(const std::string& function, CallHistoryBase& history, const FunctionEvidence& found) {
  if (found.wrong == 0 || !found.agreeing.empty() || found.isUnwritten) return false;
  try {
    for (const std::size_t call : someWrongCalls(history)) {
      if (answersOtherwise(history, call)) return true;
    }
  } catch (const SubmissionFault&) {  // among earlier calls that the session has asked again, perhaps
    return Session::current().unreliable().contains(function);
  }
  return false;
}

}  // namespace muelle::grader
