#include "course/testing/common_mistake.h"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <cmath>

namespace muelle {

namespace {

struct CommonMistake {
  std::string_view id;
  double factor;
};

/// The first whose id fits counts: a longer one stands before its end.
constexpr auto commonMistakes = std::to_array<CommonMistake>({
    {"wrong_sign", -1.0},
    {"halved", 0.5},
    {"half_kept", 0.5},
    {"missing_half", 2.0},
    {"doubled", 2.0},
    {"half", 0.5},
});

bool isNear(double got, double expected, double tolerance) {
  return std::isfinite(got) && std::abs(got - expected) <= tolerance;
}

/// "springForce" of "submission::springForce(xa, xb)"; "" when the source is more, or less, than one call.
std::string_view calledAlone(std::string_view source) {
  constexpr std::string_view prefix = "submission::";
  if (!source.starts_with(prefix)) return "";
  source.remove_prefix(prefix.size());
  const std::size_t open = source.find('(');
  if (open == std::string_view::npos || source.find_first_of(" .[") < open) return "";
  int depth = 0;
  for (std::size_t i = open; i < source.size(); ++i) {
    if (source[i] == '(') ++depth;
    if (source[i] == ')' && --depth == 0) return i + 1 == source.size() ? source.substr(0, open) : "";
  }
  return "";
}

}  // namespace

std::optional<double> commonFactor(std::string_view id) {
  for (const CommonMistake& mistake : commonMistakes) {
    const bool isLast = id.ends_with(mistake.id);
    const std::size_t before = id.size() - mistake.id.size();
    if (isLast && (before == 0 || id[before - 1] == '_')) return mistake.factor;
  }
  return std::nullopt;
}

void Answers::add(std::span<const double> got, std::span<const double> expected, double tolerance) {
  for (std::size_t i = 0; i < std::min(got.size(), expected.size()); ++i) {
    if (!isNear(got[i], expected[i], tolerance)) addWrong(got[i], expected[i], tolerance);
    for (const CommonMistake& mistake : commonMistakes) {
      const double factor = mistake.factor;
      if (!isNear(got[i], factor * expected[i], std::abs(factor) * tolerance)) isRefuted_[factor] = true;
    }
  }
}

void Answers::addWrong(double got, double expected, double tolerance) {
  if (wrong_++ == 0) {
    difference_ = got - expected;
    firstExpected_ = expected;
  }
  hasOneDifference_ = hasOneDifference_ && isNear(got - expected, *difference_, 2 * tolerance);
  areRightOnesDifferent_ = areRightOnesDifferent_ || std::abs(expected - firstExpected_) > 2 * tolerance;
}

std::optional<double> Answers::difference() const {
  const bool isSure = wrong_ >= fewestWrong && hasOneDifference_ && areRightOnesDifferent_;
  return isSure ? difference_ : std::nullopt;
}

std::string factorSentence(double factor, std::string_view function) {
  if (factor == -1.0) return fmt::format("{} gives the right size with the wrong sign, in every call", function);
  if (factor == 2.0) return fmt::format("{} gives twice the right answer, in every call", function);
  if (factor == 0.5) return fmt::format("{} gives half of the right answer, in every call", function);
  return "";
}

std::string differenceSentence(double difference, std::string_view function) {
  return fmt::format("{} is off by {:.6g} in every call: a term is missing, or has the wrong sign", function,
                     std::abs(difference));
}

std::optional<double> Answers::factor() const {
  if (wrong_ < fewestWrong) return std::nullopt;
  const auto holds = std::ranges::find_if(
      commonMistakes, [this](const CommonMistake& mistake) { return !isRefuted_.contains(mistake.factor); });
  return holds == commonMistakes.end() ? std::nullopt : std::optional(holds->factor);
}

std::map<std::string, Answers>& comparedAnswers() {
  static std::map<std::string, Answers> answers;
  return answers;
}

void noteComparison(std::string_view source, std::span<const double> got, std::span<const double> expected,
                    double tolerance) {
  const std::string_view function = calledAlone(source);
  if (!function.empty()) comparedAnswers()[std::string(function)].add(got, expected, tolerance);
}

}  // namespace muelle
