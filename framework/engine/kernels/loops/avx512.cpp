#include "engine/kernels/loops/lanes_2.h"
#include "engine/kernels/loops/lanes_4.h"
#include "engine/kernels/loops/lanes_8.h"
#include "engine/kernels/loops/single_lanes_16.h"
#include "engine/kernels/loops/table.h"
#include "engine/kernels/loops/tables.h"

namespace muelle::engine::kernels {

const Kernels& avx512Kernels() {
  static const Kernels table = tableOf<Lanes8, Lanes4, SingleLanes16, SingleLanes8Of16>();
  return table;
}

}  // namespace muelle::engine::kernels
