#pragma once
/// \file
/// The table of one instruction set. Included by one source for each, with its Lanes.

#include "engine/kernels/kernel_table.h"
#include "engine/kernels/loops/contact_loop.h"
#include "engine/kernels/loops/fixed_loop.h"
#include "engine/kernels/loops/group_loop.h"
#include "engine/kernels/loops/node_loop.h"
#include "engine/kernels/loops/run_loop.h"
#include "engine/kernels/loops/single_run_loop.h"

namespace muelle::engine::kernels {
namespace {

template <class Lanes, int D, bool relative, bool projected>
void fillDamping(Kernels& table) {
  constexpr int form = (relative ? 1 : 0) + (projected ? 2 : 0);
  static_assert(static_cast<int>(Damping::Both) == 3 && static_cast<int>(Damping::Projected) == 2);
  table.forceOfRun[D - 1][form][0] = forceOfRun<Lanes, D, relative, projected, false>;
  table.forceOfRun[D - 1][form][1] = forceOfRun<Lanes, D, relative, projected, true>;
}

template <class Lanes, class LanesOfGroups, int D>
void fillDimension(Kernels& table) {
  fillDamping<Lanes, D, false, false>(table);
  fillDamping<Lanes, D, true, false>(table);
  if constexpr (D > 1) {
    fillDamping<Lanes, D, false, true>(table);
    fillDamping<Lanes, D, true, true>(table);
    table.addSprings[D - 1][0] = addSprings<LanesOfGroups, D, false, false>;
    table.addSprings[D - 1][1] = addSprings<LanesOfGroups, D, true, false>;
    table.addSprings[D - 1][2] = addSprings<LanesOfGroups, D, false, true>;
    table.addSprings[D - 1][3] = addSprings<LanesOfGroups, D, true, true>;
  } else {
    table.addSprings[0][0] = addSpringsOfLine<false>;
    table.addSprings[0][1] = addSpringsOfLine<true>;
  }
  table.planarPass[D - 1] = planarPass<Lanes, D>;
  table.paddedPass[D - 1] = paddedPass<Lanes, D>;
  table.paddedContact[D - 1] = paddedContact<D>;
  table.planarContact[D - 1] = planarContact<Lanes, D>;
}

template <class Lanes, int D, bool relative, bool projected>
void fillSingleDamping(Kernels& table) {
  constexpr int form = (relative ? 1 : 0) + (projected ? 2 : 0);
  table.forceOfRunSingle[D - 1][form][0] = forceOfRunSingle<Lanes, D, relative, projected, false>;
  table.forceOfRunSingle[D - 1][form][1] = forceOfRunSingle<Lanes, D, relative, projected, true>;
}

template <class Lanes, int D>
void fillSingleRuns(Kernels& table) {
  fillSingleDamping<Lanes, D, false, false>(table);
  fillSingleDamping<Lanes, D, true, false>(table);
  fillSingleDamping<Lanes, D, false, true>(table);
  fillSingleDamping<Lanes, D, true, true>(table);
}

/// The part of single precision. \tparam Lanes doubles along arrays   \tparam Single springs along arrays
/// \tparam Sums of the pass over nodes, each register of which becomes one or two of Lanes
template <class Lanes, class Single, class Sums>
void fillSingle(Kernels& table) {
  fillSingleRuns<Single, 2>(table);
  fillSingleRuns<Single, 3>(table);
  table.planarPassSingle[1] = planarPassSingle<Sums, Lanes, 2>;
  table.planarPassSingle[2] = planarPassSingle<Sums, Lanes, 3>;
  table.toFixed = toFixed<Lanes>;
}

/// \tparam Lanes of what runs along arrays   \tparam LanesOfGroups of springs of general topology in 3D
/// \tparam Single, Sums as those of fillSingle()
template <class Lanes, class LanesOfGroups, class Single, class Sums>
Kernels tableOf() {
  Kernels table = {};
  fillDimension<Lanes, Lanes2, 1>(table);
  fillDimension<Lanes, Lanes2, 2>(table);
  fillDimension<Lanes, LanesOfGroups, 3>(table);
  fillSingle<Lanes, Single, Sums>(table);
  return table;
}

}  // namespace
}  // namespace muelle::engine::kernels
