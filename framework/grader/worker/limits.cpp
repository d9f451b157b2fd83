#include "grader/worker/limits.h"

#include "grader/worker/sanitised.h"

#include <sys/resource.h>
#include <stdexcept>

namespace muelle::grader::worker {

namespace {

void limit(__rlimit_resource resource, rlim_t value, rlim_t above = 0) {
  const rlimit both{value, value + above};
  if (setrlimit(resource, &both) != 0) throw std::runtime_error("setrlimit refused a limit");
}

}  // namespace

void applyLimits(unsigned cpuSeconds) {
  constexpr rlim_t grace = 5;  // [s]
  if (!isSanitised) limit(RLIMIT_AS, addressSpace);
  limit(RLIMIT_STACK, stack);
  limit(RLIMIT_CPU, cpuSeconds, grace);
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_FSIZE, 0);
  limit(RLIMIT_MEMLOCK, 0);
  limit(RLIMIT_MSGQUEUE, 0);
  limit(RLIMIT_NOFILE, 16);
}

}  // namespace muelle::grader::worker
