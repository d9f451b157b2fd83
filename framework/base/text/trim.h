#pragma once
#include <string_view>

namespace muelle {

/// The text without the blanks, tabs and line ends around it.
std::string_view trimmed(std::string_view text);

}  // namespace muelle
