#include "grader/authors/same_mistakes.h"

#include "base/text/lists.h"

#include <fmt/format.h>
#include <algorithm>
#include <set>

namespace muelle::grader {

namespace {

/// The group of a mistake in each criterion.
using Groups = std::vector<int>;

/// A registration of a mistake; several may have one id.
struct Registered {
  std::string id;
  Groups groups;
};

/// By function.
std::map<std::string, std::vector<Registered>> registeredIn(const std::map<std::string, Verdict>& verdicts) {
  std::map<std::string, std::vector<Registered>> all;
  for (const auto& [suite, verdict] : verdicts) {
    for (const auto& [function, evidence] : verdict.evidence) {
      std::vector<Registered>& registered = all[function];
      registered.resize(std::max(registered.size(), evidence.listed.size()));
      for (std::size_t i = 0; i < evidence.listed.size(); ++i) {
        registered[i].id = evidence.listed[i].id;
        registered[i].groups.push_back(evidence.listed[i].group);
      }
    }
  }
  return all;
}

bool isRight(const Groups& groups) {
  return std::ranges::all_of(groups, [](int group) { return group == 0; });
}

std::vector<std::string> linesOf(const std::string& function, const std::vector<Registered>& all) {
  std::map<Groups, std::set<std::string>> wrong;
  std::set<std::string> ids, idsWrong;
  for (const Registered& each : all) {
    ids.insert(each.id);
    if (isRight(each.groups)) continue;
    idsWrong.insert(each.id);
    wrong[each.groups].insert(each.id);
  }
  std::set<std::string> lines;  // many thresholds have one id: what they say is said once
  for (const auto& [groups, same] : wrong) {
    if (same.size() < 2) continue;
    lines.insert(fmt::format("{} of {} give the same numbers in every call: make them one, or ask for what differs",
                             joined(same, " and "), function));
  }
  for (const std::string& id : ids) {
    if (idsWrong.contains(id)) continue;
    lines.insert(fmt::format("{} of {} is right in every call: ask for what it spoils, or take it out", id, function));
  }
  return {lines.begin(), lines.end()};
}

}  // namespace

std::vector<std::string> mistakesNotToldApart(const std::map<std::string, Verdict>& verdicts) {
  std::vector<std::string> lines;
  for (const auto& [function, registered] : registeredIn(verdicts)) {
    std::ranges::move(linesOf(function, registered), std::back_inserter(lines));
  }
  return lines;
}

}  // namespace muelle::grader
