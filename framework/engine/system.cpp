#include "engine/system.h"

#include <fmt/format.h>

namespace muelle::engine {

std::string System::unknownName(int i) const { return fmt::format("unknown {}", i); }

}  // namespace muelle::engine
