#include "course/check/prediction.h"

#include "base/file.h"
#include "base/text/trim.h"

#include <fmt/format.h>
#include <algorithm>

namespace muelle {

namespace {

std::filesystem::path fileIn(const std::filesystem::path& folder) { return folder / "prediction.txt"; }

}  // namespace

std::optional<std::string> chosenAnswer(const Prediction& predict, const std::string& text) {
  const std::string said(trimmed(text));
  for (std::size_t i = 0; i < predict.answers.size(); ++i) {
    if (said == predict.answers[i] || said == std::to_string(i + 1)) return predict.answers[i];
  }
  return std::nullopt;
}

std::optional<std::string> keptPrediction(const Prediction& predict, const std::filesystem::path& folder) {
  if (!std::filesystem::is_regular_file(fileIn(folder))) return std::nullopt;
  const std::string kept(trimmed(readFile(fileIn(folder))));
  const bool isAsked = std::ranges::find(predict.answers, kept) != predict.answers.end();
  return isAsked ? std::optional(kept) : std::nullopt;
}

void keepPrediction(const std::string& answer, const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  writeFile(fileIn(folder), answer + "\n");
}

std::string numberedAnswers(const Prediction& predict, const std::string& between) {
  std::string text;
  for (std::size_t i = 0; i < predict.answers.size(); ++i) {
    text += fmt::format("{}{}: {}", i == 0 ? "" : between, i + 1, predict.answers[i]);
  }
  return text;
}

}  // namespace muelle
