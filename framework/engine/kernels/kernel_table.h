#pragma once
#include "engine/kernels/instruction_set.h"
#include "engine/kernels/kernel_arguments.h"

#include <cstddef>

namespace muelle::engine::kernels {

/// The loops of one instruction set. Dimensions count from 1: entry [2] is that of 3D.
struct Kernels {
  using AddSprings = void (*)(const SpringArrays& springs, const double* x, const double* v, double* f);
  using ForceOfRun = void (*)(const RunArrays& run, const PlanarState& at, std::size_t begin, std::size_t end,
                              const Planes& force);
  using PlanarPass = void (*)(const NodeSums& sums, const PlanarFinish& finish, std::size_t begin, std::size_t end);
  using PaddedPass = void (*)(const PaddedFinish& finish, std::size_t lanes);
  using PaddedContact = void (*)(const PlaneObstacle& plane, const PaddedContactArrays& arrays);
  using PlanarContact = void (*)(const PlaneObstacle& plane, const PlanarContactArrays& arrays);

  AddSprings addSprings[3][dampingForms];
  ForceOfRun forceOfRun[3][dampingForms][2];  ///< last index: 1 where the material is constant
  PlanarPass planarPass[3];
  PaddedPass paddedPass[3];
  PaddedContact paddedContact[3];
  PlanarContact planarContact[3];
};

/// The kernels in use: those of instructionSet().
const Kernels& kernels();

}  // namespace muelle::engine::kernels
