#pragma once
#include "course/check/diagnostics.h"

#include <string_view>
#include <vector>

namespace muelle {

/// Characters that look like those of C++ and are not: a no-break space, curly quotes, a minus sign, a zero-width
/// space, a Markdown fence, bytes of Latin-1. One diagnostic a line, with what to type instead; what stands in comments
/// and texts does not count.
std::vector<Diagnostic> oddCharacters(const StudentFile& file);

}  // namespace muelle
