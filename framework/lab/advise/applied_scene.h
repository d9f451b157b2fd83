#pragma once
#include "lab/advise/advice.h"

#include <filesystem>
#include <string>
#include <vector>

namespace muelle::lab {

/// The advice as a scene file.
struct AppliedScene {
  std::string text;                  ///< TOML
  std::vector<std::string> notSaid;  ///< parts that are left out and that a file cannot leave out, with the reason
};

/// The scene's file with the chosen method and step, and without the parts that were left out; what else stands in it,
/// comments too, stays. Where an axis is left out all vectors change, and the file names each node and spring.
/// Meshes are named as they are found from `folder`, where the file will lie.
///
/// Throws std::invalid_argument where there is no choice, std::runtime_error where the file is written in a way that
/// cannot be changed line by line (tables in one line).
AppliedScene appliedScene(const std::filesystem::path& file, const Advice& advice, const std::filesystem::path& folder);

/// Throws std::invalid_argument when the advice could not be written there: `target` is the scene itself, does not end
/// in .toml, or its folder is not there.
void checkTarget(const std::filesystem::path& file, const std::filesystem::path& target);

/// Writes it to `target`, reads it again and holds it against the advice. Throws as checkTarget() does.
AppliedScene writeApplied(const std::filesystem::path& file, const Advice& advice, const std::filesystem::path& target);

}  // namespace muelle::lab
