#include "grader/remote/core_pin.h"

#include <fcntl.h>
#include <sched.h>
#include <sys/file.h>

namespace muelle::grader {

CorePin::CorePin(const std::filesystem::path& locks) {
  cpu_set_t allowed;
  if (sched_getaffinity(0, sizeof allowed, &allowed) != 0) return;
  std::error_code ignored;
  std::filesystem::create_directories(locks, ignored);
  for (int core = 0; core < CPU_SETSIZE; ++core) {
    if (!CPU_ISSET(core, &allowed)) continue;
    lock_ = Descriptor(open((locks / ("core" + std::to_string(core))).c_str(), O_CREAT | O_RDWR | O_CLOEXEC, 0644));
    if (!lock_ || flock(lock_.get(), LOCK_EX | LOCK_NB) != 0) continue;
    cpu_set_t one;
    CPU_ZERO(&one);
    CPU_SET(core, &one);
    sched_setaffinity(0, sizeof one, &one);
    return;
  }
  lock_.reset();  // every core is taken: the scheduler decides
}

}  // namespace muelle::grader
