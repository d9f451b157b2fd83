#include "grader/testing/wrong_answers.h"

#include "base/text/fnv1a.h"

#include <algorithm>
#include <array>
#include <bit>
#include <string>

namespace muelle::grader {

namespace {

constexpr std::size_t mostAnswers = 16;
constexpr std::size_t mostNumbersOfOne = 12;

/// Of the numbers of all arguments, bit by bit; zero has one sign.
std::uint64_t questionOf(const std::vector<ArgumentItem>& items) {
  std::string bytes;
  for (const ArgumentItem& item : items) {
    for (const double number : item.numbers) {
      const auto bits = std::bit_cast<std::array<char, sizeof(double)>>(number + 0.0);
      bytes.append(bits.begin(), bits.end());
    }
  }
  return fnv1a(bytes);
}

}  // namespace

std::vector<WrongAnswer> sampleOfWrongAnswers(const CallHistoryBase& history) {
  std::map<std::uint64_t, std::size_t> wrong;  // a question asked twice counts once
  for (std::size_t call = 0; call < history.calls(); ++call) {
    if (agree(history.outcome(call), history.oracle(call), history.roundOff(call))) continue;
    wrong.try_emplace(questionOf(history.items(call)), call);
    if (wrong.size() > mostAnswers) wrong.erase(std::prev(wrong.end()));
  }
  std::vector<WrongAnswer> sample;
  for (const auto& [question, call] : wrong) {
    WrongAnswer answer{question, history.outcome(call), history.roundOff(call)};
    answer.numbers.resize(std::min(answer.numbers.size(), mostNumbersOfOne));
    sample.push_back(std::move(answer));
  }
  return sample;
}

}  // namespace muelle::grader
