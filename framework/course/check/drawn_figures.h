#pragma once
#include <filesystem>
#include <vector>

namespace muelle {

/// Removes the figures that the latest check has drawn into `folder`, with their data and scripts: one that stays when
/// the next check cannot draw it would be taken for the next one's. What others have drawn there is left alone:
/// `muelle run` does so where a scene has an exercise's name.
void removeDrawnFigures(const std::filesystem::path& folder);

/// Notes in `folder` which figures (FOLDER/ID.svg) a check has drawn, for removeDrawnFigures().
void noteDrawnFigures(const std::filesystem::path& folder, const std::vector<std::filesystem::path>& figures);

}  // namespace muelle
