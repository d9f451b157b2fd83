#include "engine/dynamical_system.h"

#include <fmt/format.h>

namespace muelle::engine {

std::string DynamicalSystem::unknownName(int i) const { return fmt::format("unknown {}", i); }

}  // namespace muelle::engine
