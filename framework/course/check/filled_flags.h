#pragma once
#include <string>
#include <string_view>

namespace muelle {

/// The source with each local `bool x;` filled by a value that is none, for the second build, whose sanitizer then sees
/// it read: GCC's own pattern for a bool is false (the field of a struct gets the bytes 0xFE). Lines stay where they
/// are.
std::string withFilledFlags(std::string_view source);

/// The source with each local `double x;` filled by a large positive number (0x7F in each byte, 1.4e306), for the build
/// with another fill: the usual one is as large, and negative, so that of two comparisons with what was never written
/// at most one is right. Zero would do for what is compared with sizes: max(0, L) is L.
std::string withFilledNumbers(std::string_view source);

}  // namespace muelle
