/// \file
/// No student's code in a process that knows an expected value, and no expected value in a process that runs a
/// student's code: read off the symbols of the built programs.

#include "base/process/child.h"

#include <gtest/gtest.h>

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

constexpr const char* functions[] = {"lumpedMass(", "springForceOnA(", "springForceOnB(", "hangingAcceleration(",
                                     "accelerationBetween("};

TEST(HiddenProgram, KnowsTheOracleAndNoFunctionOfAStudent) {
  const auto lines = symbols(MUELLE_HIDDEN);
  for (const std::string function : functions) {
    EXPECT_TRUE(holds(lines, " oracle::" + function)) << function;
    for (const char* kind : {" T ", " t ", " U ", " W "})
      EXPECT_FALSE(holds(lines, kind + function)) << kind << function;
  }
  EXPECT_FALSE(holds(lines, "muelleServe"));
  EXPECT_FALSE(holds(lines, " U dlopen"));
}

TEST(Glue, KnowsTheContractAndNoOracle) {
  const auto lines = symbols(MUELLE_GLUE);
  for (const std::string function : functions) EXPECT_TRUE(holds(lines, " U " + function)) << function;
  EXPECT_FALSE(holds(lines, "oracle::"));
  EXPECT_FALSE(holds(lines, "testing::"));
}

TEST(Worker, KnowsNeitherOracleNorTests) {
  const auto lines = symbols(MUELLE_HOST);
  EXPECT_FALSE(holds(lines, "oracle::"));
  EXPECT_FALSE(holds(lines, "testing::"));
  for (const std::string function : functions) EXPECT_FALSE(holds(lines, function)) << function;
}

}  // namespace
