#define MUELLE_LANES 8
#define MUELLE_KERNELS stageKernelsAvx512
#include "engine/integrators/explicit/engines/stage_kernels_impl.h"
