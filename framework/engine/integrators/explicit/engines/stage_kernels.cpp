#include "engine/integrators/explicit/engines/stage_kernels.h"

namespace muelle::engine {

extern const StageKernels stageKernelsBaseline[5];
#if defined(__x86_64__)
extern const StageKernels stageKernelsAvx2[5];
#endif

const StageKernels& stageKernels(std::size_t n) {
  const std::size_t which = n <= 4 ? n : 0;
#if defined(__x86_64__)
  static const bool wide = __builtin_cpu_supports("avx2") != 0;
  if (wide) return stageKernelsAvx2[which];
#endif
  return stageKernelsBaseline[which];
}

}  // namespace muelle::engine
