#include "plain_loop_body.h"

namespace muelle::benchmarks {

PlainLoops plainAvx512() { return {plainForce, plainDampedForce}; }

}  // namespace muelle::benchmarks
