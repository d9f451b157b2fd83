#pragma once
/// \file
/// Printable lines (base/text/printable.h) laid out in the columns of a terminal.

#include <string>
#include <string_view>
#include <vector>

namespace muelle {

/// The line in pieces of at most `width` columns, parted at blanks where there are any; at least one character a piece.
std::vector<std::string> wrap(std::string line, int width);

/// The line in exactly `width` columns, which are at least one: with blanks after it, or cut and "…" for what is
/// missing.
std::string fitted(std::string_view line, int width);

}  // namespace muelle
