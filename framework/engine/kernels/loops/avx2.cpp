#include "engine/kernels/loops/lanes_2.h"
#include "engine/kernels/loops/lanes_4.h"
#include "engine/kernels/loops/single_lanes_8.h"
#include "engine/kernels/loops/table.h"
#include "engine/kernels/loops/tables.h"

namespace muelle::engine::kernels {

const Kernels& avx2Kernels() {
  static const Kernels table = tableOf<Lanes4, Lanes4, SingleLanes8, SingleLanes8>();
  return table;
}

}  // namespace muelle::engine::kernels
