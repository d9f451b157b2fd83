#pragma once
#include "base/build_paths.h"

#include <filesystem>

/// The checkout and the build folder that these tests look at.
inline const std::filesystem::path source = muelle::build_paths::source;
inline const std::filesystem::path binary = muelle::build_paths::binary;
