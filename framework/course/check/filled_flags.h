#pragma once
#include <string>
#include <string_view>

namespace muelle {

/// The source with each local `bool x;` filled by a value that is none, for the second build, whose sanitizer then sees
/// it read: GCC's own pattern for a bool is false (the field of a struct gets the bytes 0xFE). Lines stay where they
/// are.
std::string withFilledFlags(std::string_view source);

}  // namespace muelle
