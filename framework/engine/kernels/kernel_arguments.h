#pragma once
/// \file
/// What the loops are given: raw pointers and numbers, for these structs are read by sources of different compiler
/// flags. No pointer may be null unless it says so.

#include "engine/kernels/spring_data.h"

#include <cstddef>
#include <cstdint>

namespace muelle::engine::kernels {

/// Springs of general topology and of one damping form. The nodes of a spring are given by their first lane.
struct SpringArrays {
  std::size_t count;
  const int *a, *b;          ///< first lane of each end
  const double *k, *L0;      ///< [N/m], [m]
  const double* dRelative;   ///< [kg/s]; null where the form has none
  const double* dProjected;  ///< [kg/s]; null where the form has none
};

/// Springs i -> i + stride for all i of a range, with their material: of each spring, or one for all.
struct RunArrays {
  std::size_t stride;
  std::size_t first;         ///< the i that the arrays of the material begin with; not read where it is constant
  const double *k, *L0;      ///< [N/m], [m]
  const double* dRelative;   ///< [kg/s]; null where the form has none
  const double* dProjected;  ///< [kg/s]; null where the form has none
};

/// Positions [m] and velocities [m/s], component c of node i at [c * plane + i].
struct PlanarState {
  const double *x, *v;
  std::size_t plane;
};

/// Positions and velocities of nodes in planes, in units (FixedWindow), from the first that is looked at.
struct FixedPlanes {
  const std::int32_t *x, *v;  ///< v is not read where no spring is damped
  std::size_t plane;
  float xUnit, vUnit;  ///< [m], [m/s]
};

/// Springs i -> i + stride from the first node on, with their material in single precision: of each spring, or one for
/// all.
struct SingleRunArrays {
  std::size_t stride;
  const float *k, *L0;      ///< [N/m], [m]
  const float* dRelative;   ///< [kg/s]; null where the form has none
  const float* dProjected;  ///< [kg/s]; null where the form has none
};

/// One vector a node or spring in planes: component c of entry i at data[c * plane + i].
template <class Real>
struct PlanesOf {
  Real* data;
  std::size_t plane;
};
using Planes = PlanesOf<double>;
using SinglePlanes = PlanesOf<float>;

/// For each run the forces on node i by its spring i -> i + stride, and by where that spring begins, i - stride -> i.
/// The force on a node is the sum of own - past over the runs, in their order, each entry added by itself.
template <class Real>
struct NodeSumsOf {
  std::size_t runs;
  const Real* const* own;     ///< of the first node of the range
  const Real* const* past;    ///< of the first node of the range
  const std::size_t* planes;  ///< of each run, between components
};
using NodeSums = NodeSumsOf<double>;
using SingleNodeSums = NodeSumsOf<float>;

/// What becomes of a node's sum F [N] of spring forces, in planes.
/// Accelerations: out = (added + F - drag v) / m + gravity, 0 where 1/m = 0. Forces: out = added + F - drag v + m
/// gravity.
struct PlanarFinish {
  double* out;                ///< [m/s^2], or [N]
  std::size_t plane;          ///< of out, added and v
  const double* added;        ///< [N] other forces on the nodes; null: none; may be `out`
  const double* v;            ///< [m/s]; read only with drag
  const double* drag;         ///< [kg/s] of each node; null: none
  const double* inverseMass;  ///< [1/kg] of each node; null: forces are wanted
  const double* mass;         ///< [kg] of each node, for forces alone; null: no gravity
  double gravity[3];          ///< [m/s^2]
};

/// The same for padded lanes: f holds the sum of forces and out takes the accelerations; they may be the same array.
struct PaddedFinish {
  const double* f;            ///< [N]
  double* out;                ///< [m/s^2]
  const double* v;            ///< [m/s]; read only with drag
  const double* drag;         ///< [kg/s] of each lane; null: none
  const double* inverseMass;  ///< [1/kg] of each lane, 0 in padding and where a node is held
  double gravity[3];          ///< [m/s^2]
};

/// A half space below a plane that pushes: N = k depth - d (v - velocity) . n, never less than 0, along n.
struct PlaneObstacle {
  double normal[3];    ///< outward, of length 1
  double point[3];     ///< [m] on the plane, now
  double velocity[3];  ///< [m/s] of the plane
  double k, d;         ///< [N/m], [kg/s]
};

/// The nodes that may touch it, lanes padded. F n is added to out; times 1/m where that is given.
struct PaddedContactArrays {
  std::size_t nodes;
  const double *x, *v;
  const double* inverseMass;  ///< [1/kg] of each lane; null: forces
  double* out;
};

/// The same in planes.
struct PlanarContactArrays {
  std::size_t nodes;
  std::size_t plane;
  const double *x, *v;
  const double* inverseMass;  ///< [1/kg] of each node; null: forces
  double* out;
};

}  // namespace muelle::engine::kernels
