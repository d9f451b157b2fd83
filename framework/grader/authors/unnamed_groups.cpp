#include "grader/authors/unnamed_groups.h"

#include "grader/naming/name_mistakes.h"
#include "grader/remote/numbers.h"

#include <algorithm>
#include <map>

namespace muelle::grader {

namespace {

std::map<std::uint64_t, WrongAnswer> byQuestion(const std::vector<WrongAnswer>& answers) {
  std::map<std::uint64_t, WrongAnswer> all;
  for (const WrongAnswer& each : answers) all.try_emplace(each.question, each);
  return all;
}

}  // namespace

bool errAlike(const UnnamedMistake& a, const UnnamedMistake& b) {
  const auto answersOfA = byQuestion(a.answers), answersOfB = byQuestion(b.answers);
  std::size_t common = 0;
  for (const auto& [question, answer] : answersOfA) {
    const auto other = answersOfB.find(question);
    if (other == answersOfB.end()) continue;
    if (!agree(answer.numbers, other->second.numbers, answer.roundOff)) return false;
    ++common;
  }
  const std::size_t fewer = std::min(answersOfA.size(), answersOfB.size());
  return common > 0 && common >= std::min(fewer, static_cast<std::size_t>(fewestWrong));
}

std::vector<UnnamedGroup> joinAlike(std::vector<UnnamedGroup> single) {
  std::vector<UnnamedGroup> groups;
  for (UnnamedGroup& each : single) {
    const auto known = std::ranges::find_if(groups, [&each](const UnnamedGroup& group) {
      return group.topic == each.topic && group.mistake.function == each.mistake.function &&
             errAlike(group.mistake, each.mistake);
    });
    if (known == groups.end()) {
      groups.push_back(std::move(each));
    } else {
      known->handIns.insert(known->handIns.end(), each.handIns.begin(), each.handIns.end());
    }
  }
  std::ranges::stable_sort(groups, std::ranges::greater{},
                           [](const UnnamedGroup& group) { return group.handIns.size(); });
  return groups;
}

}  // namespace muelle::grader
