#include "grader/report/example_sentence.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <algorithm>
#include <cmath>

namespace muelle::grader {

namespace {

constexpr std::size_t mostNumbers = 12;

std::string shown(double number) {
  if (std::isnan(number)) return "NaN, no number";
  return std::isinf(number) ? (number < 0 ? "minus infinity" : "infinity") : fmt::format("{:.6g}", number);
}

/// To six digits, or to all where six are the same for both answers.
std::string shown(const std::vector<double>& numbers, bool exactly) {
  std::vector<std::string> texts;
  for (const double number : numbers) {
    if (texts.size() == mostNumbers) {
      texts.emplace_back("...");
      break;
    }
    texts.push_back(exactly && std::isfinite(number) ? fmt::format("{}", number) : shown(number));
  }
  if (texts.empty()) return "nothing";
  return texts.size() == 1 ? texts.front() : fmt::format("({})", fmt::join(texts, ", "));
}

}  // namespace

std::string exampleSentence(const CounterExample& example) {
  const bool exactly = shown(example.got, false) == shown(example.expected, false);
  return fmt::format("{}({}): you return {}, it is {}", example.function, fmt::join(example.arguments, ", "),
                     shown(example.got, exactly), shown(example.expected, exactly));
}

}  // namespace muelle::grader
