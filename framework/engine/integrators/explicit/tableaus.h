#pragma once
/// \file
/// Coefficients of the explicit methods, in extended precision so that their order conditions can be checked beyond the
/// precision in which they are used. Each is defined beside its method.

#include <vector>

namespace muelle::engine {

using Coefficients = std::vector<long double>;

/// The same coefficients in the precision of a step.
inline std::vector<double> rounded(const Coefficients& exact) { return {exact.begin(), exact.end()}; }

/// Coefficients of an explicit Runge-Kutta method for y' = g(t, y), y = (x, v), g = (v, F/m).
struct ButcherTableau {
  Coefficients c;               ///< times of the stages, in steps
  std::vector<Coefficients> a;  ///< row i: weights of stages 0 .. i-1
  Coefficients b;               ///< weights of the step
  /// Weights of the error estimate, b minus the embedded b, one per stage; empty without an estimate.
  Coefficients error = {};
  bool firstSameAsLast = false;  ///< the last stage is the slope at the step's end, so it is the next one's first
};

/// Coefficients of an explicit Runge-Kutta-Nystroem method for x'' = A(t, x):
/// X_i = x + c_i h v + h^2 sum_j a_ij A_j,  x+ = x + h v + h^2 sum_i b_i A_i,  v+ = v + h sum_i bv_i A_i.
struct NystromTableau {
  Coefficients c;
  std::vector<Coefficients> a;   ///< row i: weights of stages 0 .. i-1
  Coefficients b;                ///< for positions
  Coefficients bv;               ///< for velocities
  Coefficients error;            ///< b minus the embedded b
  Coefficients errorv;           ///< bv minus the embedded bv
  bool firstSameAsLast = false;  ///< the last stage is the force at the step's end
};

/// Dense output of an explicit Runge-Kutta method: stages of its own after the slope at the step's end, and weights of
/// the last four coefficients of the interpolant (Hairer, Norsett and Wanner, II.6).
struct DenseTableau {
  Coefficients c;               ///< times of the extra stages
  std::vector<Coefficients> a;  ///< their rows
  std::vector<Coefficients> d;  ///< four rows, over all stages
};

ButcherTableau explicitEulerTableau();
ButcherTableau explicitMidpointTableau();
ButcherTableau rungeKutta4Tableau();
ButcherTableau dormandPrince5Tableau();
ButcherTableau dop853Tableau();
DenseTableau dop853Dense();
NystromTableau rkn64Tableau();
NystromTableau nystrom8Tableau();
NystromTableau nystrom12Tableau();

/// Fractions of the step of a symmetric composition, all of them.
Coefficients yoshida4Fractions();
Coefficients kahanLi8Fractions();

}  // namespace muelle::engine
