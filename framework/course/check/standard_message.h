#pragma once
#include <string>
#include <string_view>

namespace muelle {

/// What a broken rule of the standard library means to a student: "used an index beyond the end of a std::vector". The
/// function's name goes before it.
/// \param condition the library's assertion: "__n < this->size()"
/// \param prettyFunction the compiler's name of the member that asserts
std::string standardMessage(std::string_view condition, std::string_view prettyFunction);

}  // namespace muelle
