#pragma once
#include "engine/kernels/kernel_table.h"

namespace muelle::engine::kernels {

/// The kernels of each instruction set; on other processors than x86-64 there is the baseline alone.
const Kernels& baselineKernels();
#if defined(__x86_64__)
const Kernels& avx2Kernels();
const Kernels& avx512Kernels();
#endif

}  // namespace muelle::engine::kernels
