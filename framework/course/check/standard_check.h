#pragma once
#include <string>
#include <string_view>

namespace muelle {

/// What an assertion of the standard library means, to follow the name of the student's function: "used an index beyond
/// the end of a std::vector". \param condition the assertion's text, or a message that holds it: "__n < this->size()"
/// Returns "" for a condition without words of its own.
std::string standardCheckText(std::string_view condition);

}  // namespace muelle
