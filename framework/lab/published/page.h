#pragma once
#include <string>

namespace muelle::published {

/// The documentation page of the published problems in Markdown, made by solving them: docs/published.md is this text,
/// and a test keeps it so.
std::string publishedPage();

}  // namespace muelle::published
