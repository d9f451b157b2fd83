#pragma once
#include "course/manifest.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace muelle {

/// A GoogleTest suite of a test program of an exercise.
struct TestSuite {
  std::string name;
  int tests = 0;  ///< that run: those that are disabled do not count
};

/// The suites that the manifest pays for, in its order.
std::vector<std::string> suitesOf(const Manifest& manifest);

/// Adds a test to its suite, which it appends when it is new. One that is disabled, by its name or its suite's, makes
/// the suite known and does not count.
void countTest(std::vector<TestSuite>& suites, std::string_view suite, std::string_view test);

/// The suites of a source, in the order of their first test: TEST(Suite, Name), TEST_F, TEST_P.
std::vector<TestSuite> suitesInSource(std::string_view source);

/// What a test program has must be what the manifest pays for. Each disagreement is one line that names both files:
/// a criterion without suite, a suite without criterion, a suite of which no test runs, in this order: a misspelt name
/// is told with its criterion first.
/// \param manifestName, sourceName the files as they are shown: "exercises/triangle/exercise.toml"
std::vector<std::string> disagreements(const Manifest& manifest, const std::vector<TestSuite>& suites,
                                       std::string_view manifestName, std::string_view sourceName);

/// The same for the public tests, which need not have a suite for every criterion: a suite without criterion has no
/// hint.
std::vector<std::string> publicDisagreements(const Manifest& manifest, const std::vector<TestSuite>& suites,
                                             std::string_view manifestName, std::string_view sourceName);

/// The first disagreement of an exercise as its sources in the checkout are, nothing built: of the hidden tests, which
/// authors have, then of the public ones. "" when there is none.
std::string firstDisagreement(const std::filesystem::path& checkout, const Manifest& manifest);

}  // namespace muelle
