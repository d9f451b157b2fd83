/// \file
/// No student's code in a process that knows an expected value, and no expected value in a process that runs a
/// student's code: read off the symbols of the programs built for each exercise.

#include "base/file.h"
#include "base/process/child.h"
#include "grader/built_exercises.h"
#include "grader/run/workplace.h"

#include <gtest/gtest.h>

#include <regex>
#include <sstream>
#include <string>
#include <vector>

namespace {

/// Demangled symbols of a program or archive, one line each, as nm prints them.
std::vector<std::string> symbols(const std::string& file) {
  muelle::ChildSpec spec;
  spec.command = {"/usr/bin/nm", "-C", file};
  const auto result = muelle::runCommand(spec, {std::chrono::seconds(20), 64 << 20, 65536, 0, false});
  EXPECT_FALSE(result.out.empty()) << "nm has read nothing of " << file << ": " << result.err;
  std::vector<std::string> lines;
  std::istringstream stream(result.out);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

bool holds(const std::vector<std::string>& lines, const std::string& text) {
  for (const std::string& line : lines) {
    if (line.find(text) != std::string::npos) return true;
  }
  return false;
}

/// An exercise: its built programs, and its functions as symbols begin with them ("springForce(").
struct Exercise {
  std::string topic, hidden, glue;
  std::vector<std::string> functions;
};

/// What the contract names in MUELLE_FUNCTIONS.
std::vector<std::string> functionsOf(const std::string& contract) {
  std::smatch list;
  if (!std::regex_search(contract, list, std::regex(R"(\nMUELLE_FUNCTIONS\(([^)]*)\))"))) return {};
  const std::string names = list[1];
  const std::regex word(R"(\w+)");
  std::vector<std::string> functions;
  for (std::sregex_iterator it(names.begin(), names.end(), word), end; it != end; ++it) {
    functions.push_back(it->str() + "(");
  }
  return functions;
}

std::vector<Exercise> exercises() {
  const auto workplace = muelle::grader::Workplace::ofThisBuild();
  const muelle::grader::BuiltExercises built(workplace);
  std::vector<Exercise> exercises;
  for (const muelle::Manifest& manifest : built.all()) {
    const std::string& topic = manifest.topic;
    exercises.push_back({topic, workplace.hiddenProgram(topic), workplace.glue(topic),
                         functionsOf(muelle::readFile(workplace.contract(topic)))});
    EXPECT_FALSE(exercises.back().functions.empty()) << topic;
  }
  EXPECT_FALSE(exercises.empty());
  return exercises;
}

TEST(HiddenProgram, KnowsTheOracleAndNoFunctionOfAStudent) {
  for (const Exercise& exercise : exercises()) {
    SCOPED_TRACE(exercise.topic);
    const auto lines = symbols(exercise.hidden);
    for (const std::string& function : exercise.functions) {
      EXPECT_TRUE(holds(lines, " oracle::" + function)) << function;
      for (const char* kind : {" T ", " t ", " U ", " W "})
        EXPECT_FALSE(holds(lines, kind + function)) << kind << function;
    }
    EXPECT_FALSE(holds(lines, "muelleServe"));
    EXPECT_FALSE(holds(lines, " U dlopen"));
  }
}

TEST(Glue, KnowsTheContractAndNoOracle) {
  for (const Exercise& exercise : exercises()) {
    SCOPED_TRACE(exercise.topic);
    const auto lines = symbols(exercise.glue);
    for (const std::string& function : exercise.functions) EXPECT_TRUE(holds(lines, " U " + function)) << function;
    EXPECT_FALSE(holds(lines, "oracle::"));
    EXPECT_FALSE(holds(lines, "testing::"));
  }
}

TEST(Worker, KnowsNeitherOracleNorTests) {
  const auto lines = symbols(MUELLE_HOST);
  EXPECT_FALSE(holds(lines, "oracle::"));
  EXPECT_FALSE(holds(lines, "testing::"));
  for (const Exercise& exercise : exercises()) {
    for (const std::string& function : exercise.functions) EXPECT_FALSE(holds(lines, function)) << function;
  }
}

}  // namespace
