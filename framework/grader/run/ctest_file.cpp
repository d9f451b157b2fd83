#include "grader/run/grade.h"

#include <fmt/format.h>

namespace muelle::grader {

namespace {

/// add_test and set_tests_properties as they stand in a CTestTestfile.cmake.
std::string test(const std::string& name, const std::string& command, const std::string& topic,
                 const std::string& properties) {
  return fmt::format("add_test([=[{0}]=] {1})\nset_tests_properties([=[{0}]=] PROPERTIES LABELS \"grade;{2}\" {3})\n",
                     name, command, topic, properties);
}

}  // namespace

std::string ctestFile(const Workplace& workplace, const std::vector<Manifest>& course) {
  std::string text = "# Generated from exercises/*/exercise.toml: one test per criterion of a submission.\n";
  const std::string program = fmt::format("[=[{}]=]", workplace.stepProgram().string());
  for (const Manifest& manifest : course) {
    const std::string& topic = manifest.topic;
    const std::string needsWorker = fmt::format("FIXTURES_REQUIRED worker_{}", topic);
    text += test(fmt::format("grade.{}.build", topic), fmt::format("{} build {}", program, topic), topic,
                 fmt::format("FIXTURES_SETUP worker_{}", topic));
    for (const Criterion& criterion : manifest.criteria) {
      text += test(fmt::format("grade.{}.{}", topic, criterion.suite),
                   fmt::format("{} criterion {} {}", program, topic, criterion.suite), topic, needsWorker);
    }
    text +=
        test(fmt::format("grade.{}.curves", topic), fmt::format("{} curves {}", program, topic), topic, needsWorker);
  }
  return text;
}

}  // namespace muelle::grader
