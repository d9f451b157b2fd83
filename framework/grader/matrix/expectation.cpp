#include "grader/matrix/expectation.h"

#include "base/text/lists.h"
#include "base/text/nearest.h"
#include "base/text/trim.h"
#include "course/suites.h"
#include "grader/naming/generic_ids.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <vector>

namespace muelle::grader {

namespace {

constexpr const char* form = "// loses: SuiteA, SuiteB; misconception: id or id";

[[noreturn]] void fail(const std::string& shown, const std::string& complaint) {
  throw std::runtime_error(fmt::format("{}:1: {}", shown, complaint));
}

std::vector<std::string> misconceptionsOf(const Manifest& manifest) {
  std::vector<std::string> ids;
  for (const Misconception& misconception : manifest.misconceptions) {
    if (std::find(ids.begin(), ids.end(), misconception.id) == ids.end()) ids.push_back(misconception.id);
  }
  for (const char* id : genericIds) ids.emplace_back(id);
  return ids;
}

void checkKnown(const std::string& name, const char* what, const std::vector<std::string>& known,
                const std::string& shown) {
  if (std::find(known.begin(), known.end(), name) != known.end()) return;
  fail(shown, fmt::format("no {} '{}' in exercise.toml{}", what, name, suggestion(name, known)));
}

std::set<std::string> readSuites(const std::string& list, const std::string& shown, const Manifest& manifest) {
  std::set<std::string> lost;
  for (const std::string& suite : parted(list, ",")) {
    if (suite.empty()) fail(shown, fmt::format("an empty name in the list of suites; write {}", form));
    if (suite == "all") fail(shown, "'all' stands alone: it is every suite of exercise.toml");
    checkKnown(suite, "suite", suitesOf(manifest), shown);
    if (!lost.insert(suite).second) fail(shown, fmt::format("suite '{}' stands twice", suite));
  }
  return lost;
}

/// "idA or idB"
std::set<std::string> readNames(const std::string& list, const std::string& shown, const Manifest& manifest) {
  std::set<std::string> names;
  for (const std::string& id : parted(list, " or ")) {
    checkKnown(id, "misconception", misconceptionsOf(manifest), shown);
    names.insert(id);
  }
  return names;
}

}  // namespace

Expectation fullMarks() { return {}; }

Expectation noPoints(const Manifest& manifest) {
  Expectation expectation;
  for (const std::string& suite : suitesOf(manifest)) expectation.lost.insert(suite);
  expectation.noPoints = true;
  return expectation;
}

Expectation readExpectation(const std::string& source, const std::string& shown, const Manifest& manifest) {
  const std::string line(trimmed(source.substr(0, source.find('\n'))));
  const std::string losesKey = "// loses:";
  const std::string namedKey = "misconception:";
  const std::size_t semicolon = line.find(';');
  if (!line.starts_with(losesKey) || semicolon == std::string::npos) {
    fail(shown, fmt::format("the first line must read {}", form));
  }
  const std::string suites(trimmed(line.substr(losesKey.size(), semicolon - losesKey.size())));
  const std::string rest(trimmed(line.substr(semicolon + 1)));
  const std::string id = rest.starts_with(namedKey) ? std::string(trimmed(rest.substr(namedKey.size()))) : "";
  if (id.empty()) fail(shown, fmt::format("no misconception is stated; the first line must read {}", form));

  Expectation expectation = suites == "all" ? noPoints(manifest) : Expectation{};
  if (suites != "all") expectation.lost = readSuites(suites, shown, manifest);
  if (id != "none") expectation.named = readNames(id, shown, manifest);
  return expectation;
}

}  // namespace muelle::grader
