#pragma once
#include <filesystem>

namespace muelle::lab {

/// The folder of the scenes that come with the course.
std::filesystem::path shippedScenes();

}  // namespace muelle::lab
