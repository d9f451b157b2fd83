#include "engine/kernels/loops/lanes_2.h"
#include "engine/kernels/loops/single_lanes_4.h"
#include "engine/kernels/loops/table.h"
#include "engine/kernels/loops/tables.h"

namespace muelle::engine::kernels {

const Kernels& baselineKernels() {
  static const Kernels table = tableOf<Lanes2, Lanes2, SingleLanes4, SingleLanes4>();
  return table;
}

}  // namespace muelle::engine::kernels
