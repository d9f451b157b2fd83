#pragma once
#include <gtest/gtest.h>

#include <set>
#include <string>
#include <utility>

namespace muelle::grader {

/// Function and id of the mistakes that tests look for themselves, as MUELLE_SEEN_MISTAKE lists them.
inline std::set<std::pair<std::string, std::string>>& mistakesToBeSeen() {
  static std::set<std::pair<std::string, std::string>> all;
  return all;
}

/// Says that the running test has seen a mistake of the student's function at work: how often it asks, where its
/// questions lead, what becomes of the energy. It is named, in the words of the manifest, where the criterion is lost.
/// MUELLE_MISTAKE is for mistakes that show in the numbers of every answer; this one for those of a method that is
/// free, whose numbers are nobody's. One a test: the last one counts.
/// \param function of the contract
/// \param id of the manifest, listed by MUELLE_SEEN_MISTAKE; nothing is said of another one
inline void noteSeen(const std::string& function, const std::string& id) {
  if (!mistakesToBeSeen().contains({function, id})) return;
  ::testing::Test::RecordProperty("seen", function + " " + id);
}

}  // namespace muelle::grader

/// In mistakes.cpp, at namespace level: a mistake that a test may note as seen, with the words of the manifest.
#define MUELLE_SEEN_MISTAKE(function, id)                     \
  [[maybe_unused]] static const bool seen_##function##_##id = \
      muelle::grader::mistakesToBeSeen().emplace(#function, #id).second
