#pragma once
#include "grader/authors/unnamed.h"

namespace muelle::grader {

/// Hand-ins that give the same wrong answers, for which no mistake is named.
struct UnnamedGroup {
  std::string topic;
  std::vector<std::string> handIns;  ///< their names; untrusted text
  UnnamedMistake mistake;            ///< of the first
  std::string source;                ///< of the first; untrusted text
};

/// Whether two hand-ins that were asked the same err alike: they were wrong at three questions in common, or at all
/// that one of them has, and gave the same numbers to six digits at each in common. Where one ended early, that is what
/// it was asked.
bool errAlike(const UnnamedMistake& a, const UnnamedMistake& b);

/// Joins groups of one hand-in each, those of one exercise and function that err alike; the largest first.
std::vector<UnnamedGroup> joinAlike(std::vector<UnnamedGroup> single);

}  // namespace muelle::grader
