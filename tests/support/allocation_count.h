#pragma once

namespace muelle {

/// Number of calls of operator new in this program so far.
long allocationCount();

}  // namespace muelle
