#include "grader/run/grade.h"

#include <fmt/format.h>

namespace muelle::grader {

namespace {

/// One test as it stands in a CTestTestfile.cmake: grade.TOPIC.NAME runs the step program with `step`.
/// `ctest --preset` is started in the checkout, so that is where a relative MUELLE_SUBMISSION starts.
std::string test(const Workplace& workplace, const std::string& topic, const std::string& name, const std::string& step,
                 const std::string& fixture) {
  return fmt::format(
      "add_test([=[grade.{0}.{1}]=] [=[{2}]=] {3})\n"
      "set_tests_properties([=[grade.{0}.{1}]=] PROPERTIES LABELS \"grade;{0}\" WORKING_DIRECTORY [=[{4}]=] {5} "
      "worker_{0})\n",
      topic, name, workplace.stepProgram().string(), step, workplace.source.string(), fixture);
}

}  // namespace

std::string ctestFile(const Workplace& workplace, const std::vector<Manifest>& course) {
  std::string text = "# Generated from exercises/*/exercise.toml: one test per criterion of a submission.\n";
  for (const Manifest& manifest : course) {
    const std::string& topic = manifest.topic;
    text += test(workplace, topic, "build", "build " + topic, "FIXTURES_SETUP");
    for (const Criterion& criterion : manifest.criteria) {
      text += test(workplace, topic, criterion.suite, fmt::format("criterion {} {}", topic, criterion.suite),
                   "FIXTURES_REQUIRED");
    }
    text += test(workplace, topic, "curves", "curves " + topic, "FIXTURES_REQUIRED");
  }
  return text;
}

}  // namespace muelle::grader
