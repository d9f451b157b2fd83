#pragma once
#include "reference/binary128.h"

#include <string>
#include <vector>

namespace muelle::hard_cases {

/// A number that this project derived, by the name under which cases.json keeps it.
struct Derived {
  std::string id;    ///< "H12"
  std::string name;  ///< "one_d.z2(1)"
  Quad value;
};

/// The references that the collection of cases leaves to be derived, each from its own closed form or from the
/// independent binary128 integrator. `tolerance` is that integrator's: the values of cases.json are those of 1e-26; the
/// tests derive them again with 1e-16, which is faster and still good to 12 digits.
///
/// H06  The start is a uniform circle: spring length sqrt(0.8175^2 + 0.613125^2) = 1.021875, tension
///      100 (1.021875 - 0.858375) = 16.35, its vertical part 16.35 * 0.6 = 9.81 = m g, its horizontal part
///      16.35 * 0.8 = 13.08 = m omega^2 r with omega = 3.27 / 0.8175 = 4. So x = r (cos 4t, sin 4t), z constant, and
///      E = m v^2/2 + m g z + k (L - L0)^2/2 with the height counted from the anchor.
/// H10  Fixed-fixed chain of 50: eigenvectors sin(i j pi/51), omega_j = 2 sqrt(c/m) sin(j pi/102) with c = k along the
///      chain, c = T/a = k (a - L0)/a across it (small amplitudes). The given starts are sums of eigenvectors, so
///      u_i(t) = sum A_j sin(i j pi/51) cos(omega_j t). "nonlinear": the wave across the chain by the integrator, with
///      the lengths as they are; it differs in the eleventh digit, by (wave's slope)^2 k/T.
/// H12  static: the upper spring carries both weights, the lower one the heavy node's. one_d: the offsets
///      from there move in the two modes of the 2x2 problem (k/m1) [[2, -1], [-m1/m2, m1/m2]], whose
///      eigenvalues are solutions of a quadratic. swing: trajectory by the integrator. Both start at their rest
///      lengths: their energy is that of gravity.
/// H15  By symmetry x = 0 stays. E(y) = k (sqrt(w^2 + y^2) - L0)^2 + ka w^2 (y - 1)^2 / 2, w = 0.75. force_t0 =
///      -E'(-1). Trajectory by the integrator; y_top, the other end of the swing, where E(y) = E(-1). The inverted
///      minimum exists while E' has two roots in y < 0; they merge where E' = E'' = 0, that is where
///      ka(y) = 2 k (L - L0) y / (L w^2 (1 - y)) is largest: the root of its derivative by bisection.
/// H20  Coulomb: it slides when tan(angle) > mu, then with a = g (sin - mu cos); on the flat it stops after v0 / (mu
///      g).
/// H22  Constant force for 1 ms, then uniform motion.
std::vector<Derived> derivedReferences(Quad tolerance);

/// State (x, z, vx, vz) of H04's elastic pendulum after `duration`, started from rest at (x, z): the integrator against
/// a trajectory that another program computed.
QuadVector elasticPendulum(Quad k, Quad x, Quad z, Quad duration, Quad tolerance);

}  // namespace muelle::hard_cases
