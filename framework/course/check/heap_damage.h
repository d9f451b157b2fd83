#pragma once
#include <string>
#include <string_view>

namespace muelle {

/// What the C library says of a broken heap before it aborts, as the end of a sentence about a function: "damaged the
/// heap: ... (free(): invalid pointer)"; "" when it has said nothing of the kind. \param output of the program that
/// aborted
std::string heapDamage(std::string_view output);

}  // namespace muelle
