#pragma once
#include "course/manifest.h"

#include <filesystem>
#include <optional>
#include <string>

namespace muelle {

/// The answer that `text` chooses: its number, from 1, or its own words; nullopt for another.
std::optional<std::string> chosenAnswer(const Prediction& predict, const std::string& text);

/// The answer that was kept in `folder`; nullopt when there is none, or none of those that are asked for now.
std::optional<std::string> keptPrediction(const Prediction& predict, const std::filesystem::path& folder);

/// Keeps it there, in place of an earlier one.
void keepPrediction(const std::string& answer, const std::filesystem::path& folder);

/// "1: it grows, 2: it stays", with `between` between them.
std::string numberedAnswers(const Prediction& predict, const std::string& between);

}  // namespace muelle
