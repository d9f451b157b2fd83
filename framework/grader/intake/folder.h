#pragma once
#include "grader/intake/collector.h"

#include <filesystem>

namespace muelle::grader {

/// Walks the folder, the shallow places first and names in order, and offers what it finds to the collector. Below
/// `folder` no link is followed and nothing but a regular file with a single name is opened.
/// Throws std::runtime_error when the folder itself cannot be read.
void readFolder(const std::filesystem::path& folder, Collector& collector);

}  // namespace muelle::grader
