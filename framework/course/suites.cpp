#include "course/suites.h"

#include "base/file.h"
#include "base/text/nearest.h"
#include "base/text/trim.h"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <iterator>

namespace muelle {

namespace {

constexpr std::string_view disabled = "DISABLED_";

std::vector<std::string> namesOf(const std::vector<TestSuite>& suites) {
  std::vector<std::string> names;
  for (const TestSuite& suite : suites) names.push_back(suite.name);
  return names;
}

/// Suites that no criterion names, and suites of which no test runs.
std::vector<std::string> ofSuites(const Manifest& manifest, const std::vector<TestSuite>& suites,
                                  std::string_view manifestName, std::string_view sourceName) {
  std::vector<std::string> lines;
  const std::vector<std::string> stated = suitesOf(manifest);
  for (const TestSuite& suite : suites) {
    if (std::ranges::find(stated, suite.name) == stated.end()) {
      lines.push_back(fmt::format(
          "{}: suite {} is no criterion of {}; add a [[criterion]] with suite = \"{}\", or rename the suite{}",
          sourceName, suite.name, manifestName, suite.name, didYouMean(suite.name, stated)));
    } else if (suite.tests == 0) {
      lines.push_back(fmt::format("{}: suite {}, a criterion of {}, is empty: no test of it runs", sourceName,
                                  suite.name, manifestName));
    }
  }
  return lines;
}

}  // namespace

std::vector<std::string> suitesOf(const Manifest& manifest) {
  std::vector<std::string> names;
  for (const Criterion& criterion : manifest.criteria) names.push_back(criterion.suite);
  return names;
}

void countTest(std::vector<TestSuite>& suites, std::string_view suite, std::string_view test) {
  const bool runs = !suite.starts_with(disabled) && !test.starts_with(disabled);
  auto known = std::ranges::find(suites, suite, &TestSuite::name);
  if (known == suites.end()) known = suites.insert(suites.end(), TestSuite{std::string(suite), 0});
  if (runs) ++known->tests;
}

std::vector<TestSuite> suitesInSource(std::string_view source) {
  constexpr auto macros = std::to_array<std::string_view>({"TEST(", "TEST_F(", "TEST_P("});
  std::vector<TestSuite> suites;
  while (!source.empty()) {
    const std::size_t end = std::min(source.find('\n'), source.size());
    const std::string_view line = source.substr(0, end);
    const auto macro = std::ranges::find_if(macros, [line](std::string_view m) { return line.starts_with(m); });
    if (macro != macros.end()) {
      // The two names may stand on two lines.
      const std::string_view arguments = source.substr(macro->size(), source.find(')') - macro->size());
      const std::size_t comma = std::min(arguments.find(','), arguments.size());
      countTest(suites, trimmed(arguments.substr(0, comma)),
                trimmed(arguments.substr(std::min(comma + 1, arguments.size()))));
    }
    source.remove_prefix(std::min(end + 1, source.size()));
  }
  return suites;
}

std::vector<std::string> disagreements(const Manifest& manifest, const std::vector<TestSuite>& suites,
                                       std::string_view manifestName, std::string_view sourceName) {
  std::vector<std::string> lines;
  const std::vector<std::string> known = namesOf(suites);
  for (const std::string& suite : suitesOf(manifest)) {
    if (std::ranges::find(known, suite) != known.end()) continue;
    lines.push_back(fmt::format("{}: criterion {} has no suite in {}; write TEST({}, ...), or take the criterion out{}",
                                manifestName, suite, sourceName, suite, didYouMean(suite, known)));
  }
  std::ranges::copy(ofSuites(manifest, suites, manifestName, sourceName), std::back_inserter(lines));
  return lines;
}

std::vector<std::string> publicDisagreements(const Manifest& manifest, const std::vector<TestSuite>& suites,
                                             std::string_view manifestName, std::string_view sourceName) {
  return ofSuites(manifest, suites, manifestName, sourceName);
}

std::string firstDisagreement(const std::filesystem::path& checkout, const Manifest& manifest) {
  const std::string manifestName = fmt::format("exercises/{}/exercise.toml", manifest.topic);
  const std::string publicTests = fmt::format("exercises/{}/public_test.cpp", manifest.topic);
  const std::string hiddenTests = fmt::format("tests/hidden/{0}/{0}_test.cpp", manifest.topic);
  if (const auto source = tryReadFile(checkout / hiddenTests)) {
    const auto lines = disagreements(manifest, suitesInSource(*source), manifestName, hiddenTests);
    if (!lines.empty()) return lines.front();
  }
  if (const auto source = tryReadFile(checkout / publicTests)) {
    const auto lines = publicDisagreements(manifest, suitesInSource(*source), manifestName, publicTests);
    if (!lines.empty()) return lines.front();
  }
  return "";
}

}  // namespace muelle
