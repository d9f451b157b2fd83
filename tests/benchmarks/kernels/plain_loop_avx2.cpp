#include "plain_loop_body.h"

namespace muelle::benchmarks {

PlainLoops plainAvx2() { return {plainForce, plainDampedForce}; }

}  // namespace muelle::benchmarks
