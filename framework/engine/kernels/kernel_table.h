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

  // In single precision, in 2D and 3D: a line has neither root nor quotient, and nothing to win.
  using ForceOfRunSingle = void (*)(const SingleRunArrays& run, const FixedPlanes& at, std::size_t count,
                                    const SinglePlanes& force);
  using PlanarPassSingle = void (*)(const SingleNodeSums& sums, const PlanarFinish& finish, std::size_t begin,
                                    std::size_t end);
  /// fixed[i] = (values[i] - first) perUnit, rounded to the nearest integer, of two the even one; whatever it is where
  /// that is no 32-bit integer. Returns the largest |values[i] - first|; no number where one is none.
  using ToFixed = double (*)(const double* values, double first, double perUnit, std::size_t count,
                             std::int32_t* fixed);

  AddSprings addSprings[3][dampingForms];
  ForceOfRun forceOfRun[3][dampingForms][2];  ///< last index: 1 where the material is constant
  PlanarPass planarPass[3];
  PaddedPass paddedPass[3];
  PaddedContact paddedContact[3];
  PlanarContact planarContact[3];

  ForceOfRunSingle forceOfRunSingle[3][dampingForms][2];
  PlanarPassSingle planarPassSingle[3];
  ToFixed toFixed;
};

/// The kernels in use: those of instructionSet().
const Kernels& kernels();

}  // namespace muelle::engine::kernels
