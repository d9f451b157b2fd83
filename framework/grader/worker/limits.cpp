#include "grader/worker/limits.h"

#include <sys/resource.h>
#include <stdexcept>

namespace muelle::grader::worker {

namespace {

void limit(__rlimit_resource resource, rlim_t value) {
  const rlimit both{value, value};
  if (setrlimit(resource, &both) != 0) throw std::runtime_error("setrlimit refused a limit");
}

}  // namespace

void applyLimits() {
  limit(RLIMIT_AS, addressSpace);
  limit(RLIMIT_STACK, stack);
  limit(RLIMIT_CPU, cpuSeconds);
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_FSIZE, 0);
  limit(RLIMIT_MEMLOCK, 0);
  limit(RLIMIT_MSGQUEUE, 0);
  limit(RLIMIT_NOFILE, 16);
}

}  // namespace muelle::grader::worker
