#define MUELLE_LANES 2
#define MUELLE_KERNELS stageKernelsBaseline
#include "engine/integrators/explicit/engines/stage_kernels_impl.h"
