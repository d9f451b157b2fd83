#include "grader/testing/wrong_answers.h"

#include <algorithm>
#include <bit>

namespace muelle::grader {

namespace {

constexpr std::size_t mostAnswers = 16;
constexpr std::size_t mostNumbersOfOne = 12;

/// FNV-1a over the numbers of all arguments; zero has one sign.
std::uint64_t questionOf(const std::vector<ArgumentItem>& items) {
  std::uint64_t hash = 14695981039346656037ULL;
  const auto add = [&hash](std::uint64_t bits) {
    for (int byte = 0; byte < 8; ++byte) hash = (hash ^ ((bits >> (8 * byte)) & 0xff)) * 1099511628211ULL;
  };
  for (const ArgumentItem& item : items) {
    for (const double number : item.numbers) add(std::bit_cast<std::uint64_t>(number + 0.0));
  }
  return hash;
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
