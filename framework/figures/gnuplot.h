#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace muelle {

/// Runs gnuplot on scripts, one after the other in one process, with `folder` as its current folder; no shell, no
/// input, and none of the user's gnuplot settings. Throws std::runtime_error with gnuplot's own words when it fails, or
/// with what to install when it cannot be started.
void runGnuplot(const std::filesystem::path& folder, const std::vector<std::string>& scripts);

}  // namespace muelle
