#include "grader/naming/generic_sentence.h"

#include "course/testing/common_mistake.h"

#include <fmt/format.h>
#include <array>
#include <cmath>
#include <functional>
#include <map>

namespace muelle::grader {

namespace {

constexpr const char* axes = "xyz";

/// "z"; of stacked nodes "component 5".
std::string component(int index) {
  return index < 3 ? std::string(1, axes[index]) : fmt::format("component {}", index);
}

/// One sentence a mistake; {f} the function, {p} and {q} its arguments, {v} the constant or component.
const std::map<std::string, const char*>& sentences() {
  static const std::map<std::string, const char*> table{
      {"absolute_value", "{f} loses the sign: it gives the size of the right answer, never a negative number"},
      {"always_negative", "{f} loses the sign: it gives the right size, always negative"},
      {"cut_result", "{f} cuts its answer to a whole number, as an int does"},
      {"component_sign", "{f} gives {v} with the wrong sign, and the rest right"},
      {"missing_component", "{f} gives 0 for {v}, and the rest right"},
      {"ignored", "{f} leaves {p} out: it answers as if that were 0"},
      {"missing_factor", "{f} leaves {p} out: it answers as if that were 1"},
      {"constant_argument", "{f} computes with {v} in place of {p}"},
      {"argument_sign", "{f} takes {p} with the wrong sign"},
      {"argument_size", "{f} takes the size of {p} and loses its sign"},
      {"doubled_argument", "{f} takes {p} twice"},
      {"halved_argument", "{f} takes half of {p}"},
      {"squared", "{f} takes the square of {p} where {p} itself belongs"},
      {"whole_numbers", "{f} cuts {p} to a whole number, as an int does"},
      {"factor_too_many", "{f} gives the right answer times {p}: that factor is one too many"},
      {"factor_too_few", "{f} gives the right answer divided by {p}"},
      {"multiplied_for_divided", "{f} multiplies by {p} where it should divide"},
      {"divided_for_multiplied", "{f} divides by {p} where it should multiply"},
      {"swapped_arguments", "{f} answers as if {p} and {q} were exchanged"},
      {"argument_twice", "{f} takes {p} where {q} belongs, too"},
      {"first_skipped", "{f} leaves out the first of {p}"},
      {"last_skipped", "{f} leaves out the last of {p}"},
      {"first_only", "{f} takes only the first of {p}"},
      {"last_only", "{f} takes only the last of {p}"},
      {"first_for_all", "{f} takes {p} from the first for all of them"},
  };
  return table;
}

double logBinomial(double n, double k) { return std::lgamma(n + 1) - std::lgamma(k + 1) - std::lgamma(n - k + 1); }

/// Whether so many plain right and wrong calls fall apart at one of so many features only once in a thousand by
/// accident.
bool isNoAccident(const FunctionEvidence& evidence) {
  constexpr double once = 1e-3;
  const auto wrong = static_cast<double>(evidence.wrong);
  const auto calls = static_cast<double>(evidence.plainRight + evidence.wrong);
  const auto features = static_cast<double>(evidence.features.size());
  return logBinomial(calls, wrong) > std::log(2 * features / once);
}

std::string nameOf(const Feature& feature, const std::vector<Parameter>& parameters) {
  const std::string first = wordsOf(feature.of.front(), parameters);
  if (feature.kind == "value") return first;
  if (feature.kind == "length") return fmt::format("the length of {}", first);
  if (feature.kind == "least" || feature.kind == "most") return fmt::format("the {} {}", feature.kind, first);
  if (feature.kind == "count") return fmt::format("the number of {}", first);
  const std::string second = wordsOf(feature.of.back(), parameters);
  if (feature.kind == "distance") return fmt::format("the distance of {} and {}", first, second);
  return fmt::format("{} - {}", first, second);
}

std::string shortly(double number) { return fmt::format("{:.3g}", number); }

/// A sign decides when the border lies between a negative and a positive number.
bool isSign(double below, double above) { return below <= 0 && above >= 0; }

Separation wrongBelow(const std::string& name, const FeatureRange& range, bool isLength) {
  if (range.fewestWrong < 0 && isSign(range.mostWrong, range.fewestPlain)) {
    return {"one_sided", fmt::format("{} is negative", name)};
  }
  if (range.fewestWrong == 0 && range.mostWrong == 0) return {"edge", fmt::format("{} is 0", name)};
  if (!isLength) return {};
  const std::string most = shortly(range.mostWrong);
  if (range.fewestWrong == range.mostWrong) return {"threshold", fmt::format("{} is {}", name, most)};
  // At 0 the answer is right, or was not asked for.
  return {"threshold", fmt::format("{} is {} or less{}", name, most, range.fewestWrong > 0 ? ", but not 0" : "")};
}

Separation wrongAbove(const std::string& name, const FeatureRange& range) {
  if (isSign(range.mostPlain, range.fewestWrong) && range.fewestPlain < 0) {
    return {"one_sided", fmt::format("{} is positive", name)};
  }
  return {};  // a large number is no cause: what is wrong there has another
}

/// By the first feature of these kinds that parts right from wrong.
Separation firstOf(std::initializer_list<const char*> kinds, const FunctionEvidence& evidence,
                   const std::vector<Parameter>& parameters) {
  for (const char* kind : kinds) {
    for (const auto& [feature, range] : evidence.features) {
      if (feature.kind != kind) continue;
      const std::string name = nameOf(feature, parameters);
      const bool isLength = feature.kind == "distance" || feature.kind == "length";
      Separation found;
      if (range.mostWrong < range.fewestPlain) found = wrongBelow(name, range, isLength);
      if (range.mostPlain < range.fewestWrong) found = wrongAbove(name, range);
      if (!found.id.empty()) return found;
    }
  }
  return {};
}

}  // namespace

std::string wordsOf(const Leaf& leaf, const std::vector<Parameter>& parameters) {
  const auto index = static_cast<std::size_t>(leaf.argument);
  if (index >= parameters.size()) return fmt::format("argument {}", leaf.argument + 1);
  const Parameter& parameter = parameters[index];
  std::string name = parameter.name;
  const bool isList = parameter.type.find("vector") != std::string::npos;
  if (leaf.field >= 0 && static_cast<std::size_t>(leaf.field) < parameter.fields.size()) {
    const std::string& field = parameter.fields[static_cast<std::size_t>(leaf.field)];
    name = isList ? fmt::format("{} of {}", field, name) : fmt::format("{}.{}", name, field);
  }
  return leaf.component < 0 ? name : fmt::format("{} of {}", component(leaf.component), name);
}

std::string sentenceOf(const Hypothesis& hypothesis, const std::string& function,
                       const std::vector<Parameter>& parameters) {
  if (hypothesis.id == "rope") {
    return fmt::format("{} gives 0 where the right answer is {}, and is right elsewhere", function,
                       hypothesis.value < 0 ? "negative" : "positive");
  }
  if (const auto factor = commonFactor(hypothesis.id)) return factorSentence(*factor, function);
  const auto found = sentences().find(hypothesis.id);
  if (found == sentences().end()) return "";
  const auto words = [&](std::size_t i) {
    return i < hypothesis.of.size() ? wordsOf(hypothesis.of[i], parameters) : std::string();
  };
  const bool isComponent = hypothesis.id == "component_sign" || hypothesis.id == "missing_component";
  const std::string value = isComponent ? fmt::format("component {}", static_cast<int>(hypothesis.value))
                                        : fmt::format("{}", hypothesis.value);
  return fmt::format(fmt::runtime(found->second), fmt::arg("f", function), fmt::arg("p", words(0)),
                     fmt::arg("q", words(1)), fmt::arg("v", value));
}

Separation separationOf(const FunctionEvidence& evidence, const std::vector<Parameter>& parameters) {
  if (evidence.wrong == 0 || evidence.wrong == evidence.calls || !isNoAccident(evidence)) return {};
  // A sign parts more surely than a number that happens to lie between.
  if (Separation found = firstOf({"difference"}, evidence, parameters); found.id == "one_sided") return found;
  return firstOf({"distance", "length", "value", "count", "least", "most", "difference"}, evidence, parameters);
}

}  // namespace muelle::grader
