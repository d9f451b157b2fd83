#include "plain_loop_body.h"

namespace muelle::benchmarks {

PlainLoops plainBaseline() { return {plainForce, plainDampedForce}; }

}  // namespace muelle::benchmarks
