#include "grader/matrix/ranges.h"

#include "course/contract.h"
#include "grader/naming/generic_sentence.h"

#include <fmt/format.h>
#include <algorithm>

namespace muelle::grader {

namespace {

/// Between which numbers an argument was passed.
struct Passed {
  double least, most;
};

Passed passedOf(const FeatureRange& range) {
  return {std::min(range.fewestRight, range.fewestWrong), std::max(range.mostRight, range.mostWrong)};
}

/// "k" of the argument k, of top.k and of each of springs: all have that range.
bool isNamed(const Leaf& leaf, const std::vector<Parameter>& parameters, const std::string& name) {
  const auto index = static_cast<std::size_t>(leaf.argument);
  if (index >= parameters.size() || leaf.component >= 0) return false;
  const Parameter& parameter = parameters[index];
  if (leaf.field < 0) return parameter.name == name;
  const auto field = static_cast<std::size_t>(leaf.field);
  return field < parameter.fields.size() && parameter.fields[field] == name;
}

/// Whether a feature is about what a range is about: the range of a list is that of its length, whatever numbers it
/// holds.
bool isMeant(const Feature& feature, const std::map<Feature, FeatureRange>& features) {
  if (feature.kind == "value" || feature.kind == "count") return true;
  return (feature.kind == "least" || feature.kind == "most") && !features.contains({"count", feature.of});
}

/// Ends in the same way: 1e-3 is passed by the number 1e-3, whatever round-off has made of it.
bool reachesDown(double passed, double end) { return passed <= end + 1e-9 * std::abs(end); }
bool reachesUp(double passed, double end) { return passed >= end - 1e-9 * std::abs(end); }

void addEnds(std::vector<std::string>& lines, const std::string& function, const std::string& words,
             const Feature& feature, Passed passed, const Range& range) {
  const bool looksDown = feature.kind != "most";
  const bool looksUp = feature.kind != "least";
  if (looksDown && !reachesDown(passed.least, range.least)) {
    lines.push_back(fmt::format("{}: {} is never {:g}, the least is {:g}", function, words, range.least, passed.least));
  }
  if (looksUp && !reachesUp(passed.most, range.most)) {
    lines.push_back(fmt::format("{}: {} is never {:g}, the most is {:g}", function, words, range.most, passed.most));
  }
}

}  // namespace

std::vector<std::string> endsNotPassed(std::string_view contract, const Evidence& evidence) {
  std::vector<std::string> lines;
  for (const Range& range : rangesOf(contract)) {
    for (const auto& [function, calls] : evidence) {
      const std::vector<Parameter> parameters = parametersOf(contract, function);
      for (const auto& [feature, passed] : calls.features) {
        if (!isMeant(feature, calls.features) || !isNamed(feature.of.front(), parameters, range.name)) continue;
        addEnds(lines, function, wordsOf(feature.of.front(), parameters), feature, passedOf(passed), range);
      }
    }
  }
  return lines;
}

}  // namespace muelle::grader
