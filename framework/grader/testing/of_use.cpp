#include "grader/testing/of_use.h"

#include "course/testing/random.h"
#include "grader/remote/fault.h"
#include "grader/testing/arguments.h"
#include "grader/testing/gather_evidence.h"

#include <fmt/format.h>

namespace muelle::grader {

namespace {

const GeneralPosition& argumentsOf(const std::string& function) {
  const auto found = GeneralPosition::all().find(function);
  if (found != GeneralPosition::all().end()) return found->second;
  throw GraderFault("no MUELLE_ARGUMENTS are registered for " + function);
}

/// Whether one mistake explains every answer; zero and a constant are no mistake that anything can be built on.
bool showsOneMistake(const std::string& function) {
  const auto history = CallHistoryBase::all().find(function);
  if (history == CallHistoryBase::all().end()) return false;
  const FunctionEvidence evidence = gatherEvidence(*history->second);
  return evidence.wrong > 0 && evidence.zero < evidence.calls && !evidence.isConstant && !evidence.agreeing.empty();
}

}  // namespace

::testing::AssertionResult isOfUse(const char* /*text*/, const std::string& function) {
  const std::string complaint = argumentsOf(function).examine(testRandom()).complaint;
  return complaint.empty() ? ::testing::AssertionSuccess() : ::testing::AssertionFailure() << complaint;
}

::testing::AssertionResult givesAnswers(const char* /*text*/, const std::string& function) {
  const Uselessness found = argumentsOf(function).examine(testRandom());
  const bool answers = found.complaint.empty() || found.isOneSlipAway;
  return answers ? ::testing::AssertionSuccess() : ::testing::AssertionFailure() << found.complaint;
}

std::vector<std::string> withoutArguments(const Manifest& manifest, const std::string& manifestName) {
  std::vector<std::string> lines;
  for (const Criterion& criterion : manifest.criteria) {
    for (const std::string& function : criterion.follows) {
      if (GeneralPosition::all().contains(function)) continue;
      lines.push_back(
          fmt::format("{}: criterion {} follows {}, for which mistakes.cpp has no MUELLE_ARGUMENTS({}, ...)",
                      manifestName, criterion.suite, function, function));
    }
  }
  return lines;
}

Use useToOthers(const std::string& function, std::uint64_t seed) {
  try {
    const Uselessness found = argumentsOf(function).examine(Random(seed));
    const bool isGood = found.complaint.empty() || (found.isOneSlipAway && showsOneMistake(function));
    return isGood ? Use::Good : Use::None;
  } catch (const SubmissionFault& fault) {
    return fault.outcome() == Outcome::Link ? Use::Missing : Use::None;
  }
}

}  // namespace muelle::grader
