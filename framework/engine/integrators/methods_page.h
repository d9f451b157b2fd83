#pragma once
#include <string>

namespace muelle::engine {

/// The documentation page of the methods in Markdown, made from their MethodInfo: docs/methods.md is this text, and a
/// test keeps it so.
std::string methodsPage();

}  // namespace muelle::engine
