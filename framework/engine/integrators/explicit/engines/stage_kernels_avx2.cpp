#define MUELLE_LANES 4
#define MUELLE_KERNELS stageKernelsAvx2
#include "engine/integrators/explicit/engines/stage_kernels_impl.h"
