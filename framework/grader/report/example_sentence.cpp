#include "grader/report/example_sentence.h"

#include "base/text/lists.h"

#include <fmt/format.h>
#include <algorithm>
#include <cctype>
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
  return texts.size() == 1 ? texts.front() : fmt::format("({})", joined(texts, ", "));
}

bool isDigitOrPoint(char c) { return (c >= '0' && c <= '9') || c == '.'; }

/// Digits of "0.0120" that count: 2.
std::size_t digitsThatCount(std::string number) {
  std::erase(number, '.');
  const std::size_t first = number.find_first_not_of('0');
  return first == std::string::npos ? 0 : number.find_last_not_of('0') + 1 - first;
}

/// Whether no number of a source has more digits; the exponent of 1e-9 and the 3 of Vec3 are none.
bool hasFewDigits(const std::string& source) {
  constexpr std::size_t most = 2;
  for (std::size_t at = 0; at < source.size(); ++at) {
    if (!isDigitOrPoint(source[at])) continue;
    std::size_t end = at;
    while (end < source.size() && isDigitOrPoint(source[end])) ++end;
    const bool isPartOfWord = at > 0 && std::isalpha(static_cast<unsigned char>(source[at - 1])) != 0;
    if (!isPartOfWord && digitsThatCount(source.substr(at, end - at)) > most) return false;
    at = end;
  }
  return true;
}

}  // namespace

bool isForPaper(const CounterExample& example) { return std::ranges::all_of(example.arguments, hasFewDigits); }

std::string exampleSentence(const CounterExample& example) {
  const std::string call = fmt::format("{}({})", example.function, joined(example.arguments, ", "));
  if (example.isVerdict && example.got.size() == 1 && example.expected.size() == 1) {
    return fmt::format("{}: you return {}, it is {}", call, example.got.front() != 0, example.expected.front() != 0);
  }
  const bool exactly = shown(example.got, false) == shown(example.expected, false);
  return fmt::format("{}: you return {}, it is {}", call, shown(example.got, exactly),
                     shown(example.expected, exactly));
}

}  // namespace muelle::grader
