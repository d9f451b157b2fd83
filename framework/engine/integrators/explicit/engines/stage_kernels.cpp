#include "engine/integrators/explicit/engines/stage_kernels.h"

#include "engine/kernels/instruction_set.h"

namespace muelle::engine {

extern const StageKernels stageKernelsBaseline[5];
#if defined(__x86_64__)
extern const StageKernels stageKernelsAvx2[5];
extern const StageKernels stageKernelsAvx512[5];
#endif

const StageKernels& stageKernels(std::size_t n) {
  const std::size_t which = n <= 4 ? n : 0;
#if defined(__x86_64__)
  const kernels::InstructionSet set = kernels::instructionSet();
  if (set == kernels::InstructionSet::Avx512) return stageKernelsAvx512[which];
  if (set == kernels::InstructionSet::Avx2) return stageKernelsAvx2[which];
#endif
  return stageKernelsBaseline[which];
}

}  // namespace muelle::engine
