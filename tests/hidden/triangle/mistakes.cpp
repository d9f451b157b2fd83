/// \file
/// What the usual mistakes would return: each is a whole function, so that all calls of a criterion must agree with it.

#include "grader/testing/mistakes.h"
#include "triangle.h"

#include <limits>

namespace {

constexpr int first(int spring) { return spring; }
constexpr int second(int spring) { return (spring + 1) % 3; }

Vec3 difference(const Vec9& x, int spring) {
  return x.segment<3>(3 * first(spring)) - x.segment<3>(3 * second(spring));
}
double length(const Vec9& x, int spring) { return difference(x, spring).norm(); }

/// Force of one spring on its first node.
Vec3 springForce(const Vec9& x, const Vec3& k, const Vec3& L0, int spring) {
  const double L = length(x, spring);
  if (L == 0) return Vec3::Zero();
  return -k[spring] * (L - L0[spring]) / L * difference(x, spring);
}

/// The values of a vector of the springs in another order: entry s of the result is entry from[s].
Vec3 reordered(const Vec3& values, const std::array<int, 3>& from) {
  return {values[from[0]], values[from[1]], values[from[2]]};
}
constexpr std::array<int, 3> in010212 = {0, 2, 1};        ///< values given for the springs 01, 02, 12
constexpr std::array<int, 3> byOppositeNode = {2, 0, 1};  ///< values given for the springs 12, 20, 01

/// Adds up forces on the first node of each spring and their opposites on the second, as the solution does.
template <class ForceOfSpring>
Vec9 assembled(ForceOfSpring&& forceOf) {
  Vec9 F = Vec9::Zero();
  for (int s = 0; s < 3; ++s) {
    const Vec3 force = forceOf(s);
    F.segment<3>(3 * first(s)) += force;
    F.segment<3>(3 * second(s)) -= force;
  }
  return F;
}

/// Below every length of the other criteria and above every length of the criterion on very short springs.
constexpr double threshold = 1e-12;

}  // namespace

MUELLE_MISTAKE(massMatrix, masses_interleaved, [](const Vec3& m) {
  Mat9 M = Mat9::Zero();
  for (int i = 0; i < 9; ++i) M(i, i) = m[i % 3];
  return M;
});
MUELLE_MISTAKE(massMatrix, mass_once_per_node, [](const Vec3& m) {
  Mat9 M = Mat9::Zero();
  for (int i = 0; i < 3; ++i) M(3 * i, 3 * i) = m[i];
  return M;
});
MUELLE_MISTAKE(massMatrix, inverse_mass_matrix,
               [](const Vec3& m) { return oracle::massMatrix(Vec3(m.cwiseInverse())); });

MUELLE_COMMON_MISTAKE(triangleEnergy, missing_half);
MUELLE_MISTAKE(triangleEnergy, missing_rest_length,
               [](const Vec9& x, const Vec3& k, const Vec3&) { return oracle::triangleEnergy(x, k, Vec3::Zero()); });
MUELLE_MISTAKE(triangleEnergy, difference_of_squares, [](const Vec9& x, const Vec3& k, const Vec3& L0) {
  double E = 0;
  for (int s = 0; s < 3; ++s) E += 0.5 * k[s] * (length(x, s) * length(x, s) - L0[s] * L0[s]);
  return E;
});
MUELLE_MISTAKE(triangleEnergy, overwrites, [](const Vec9& x, const Vec3& k, const Vec3& L0) {
  return oracle::triangleEnergy(x, Vec3(0, 0, k[2]), L0);
});
MUELLE_MISTAKE(triangleEnergy, two_springs, [](const Vec9& x, const Vec3& k, const Vec3& L0) {
  return oracle::triangleEnergy(x, Vec3(k[0], k[1], 0), L0);
});
MUELLE_MISTAKE(triangleEnergy, springs_reordered, [](const Vec9& x, const Vec3& k, const Vec3& L0) {
  return oracle::triangleEnergy(x, reordered(k, in010212), reordered(L0, in010212));
});
MUELLE_MISTAKE(triangleEnergy, springs_by_opposite_node, [](const Vec9& x, const Vec3& k, const Vec3& L0) {
  return oracle::triangleEnergy(x, reordered(k, byOppositeNode), reordered(L0, byOppositeNode));
});
MUELLE_MISTAKE(triangleEnergy, one_rest_length, [](const Vec9& x, const Vec3& k, const Vec3& L0) {
  return oracle::triangleEnergy(x, k, Vec3(Vec3::Constant(L0[0])));
});
MUELLE_MISTAKE(triangleEnergy, energy_lost_when_coincident, [](const Vec9& x, const Vec3& k, const Vec3& L0) {
  double E = 0;
  for (int s = 0; s < 3; ++s) {
    const double L = length(x, s);
    if (L > 0) E += 0.5 * k[s] * (L - L0[s]) * (L - L0[s]);
  }
  return E;
});

MUELLE_COMMON_MISTAKE(triangleForce, wrong_sign);
MUELLE_MISTAKE(triangleForce, missing_rest_length,
               [](const Vec9& x, const Vec3& k, const Vec3&) { return oracle::triangleForce(x, k, Vec3::Zero()); });
MUELLE_MISTAKE(triangleForce, not_normalised, [](const Vec9& x, const Vec3& k, const Vec3& L0) {
  return assembled([&](int s) { return Vec3(-k[s] * (length(x, s) - L0[s]) * difference(x, s)); });
});
MUELLE_COMMON_MISTAKE(triangleForce, half_kept);
MUELLE_MISTAKE(triangleForce, gradient_of_squared_length, [](const Vec9& x, const Vec3& k, const Vec3& L0) {
  return assembled([&](int s) { return Vec3(-2 * k[s] * (length(x, s) - L0[s]) * difference(x, s)); });
});
MUELLE_MISTAKE(triangleForce, overwrites, [](const Vec9& x, const Vec3& k, const Vec3& L0) {
  Vec9 F = Vec9::Zero();
  for (int s = 0; s < 3; ++s) {
    F.segment<3>(3 * first(s)) = springForce(x, k, L0, s);
    F.segment<3>(3 * second(s)) = -springForce(x, k, L0, s);
  }
  return F;
});
MUELLE_MISTAKE(triangleForce, without_reaction, [](const Vec9& x, const Vec3& k, const Vec3& L0) {
  Vec9 F = Vec9::Zero();
  for (int s = 0; s < 3; ++s) F.segment<3>(3 * first(s)) += springForce(x, k, L0, s);
  return F;
});
MUELLE_MISTAKE(triangleForce, same_on_both_nodes, [](const Vec9& x, const Vec3& k, const Vec3& L0) {
  Vec9 F = Vec9::Zero();
  for (int s = 0; s < 3; ++s) {
    F.segment<3>(3 * first(s)) += springForce(x, k, L0, s);
    F.segment<3>(3 * second(s)) += springForce(x, k, L0, s);
  }
  return F;
});
MUELLE_MISTAKE(triangleForce, wrong_block, [](const Vec9& x, const Vec3& k, const Vec3& L0) {
  Vec9 F = Vec9::Zero();
  for (int s = 0; s < 3; ++s) {
    F.segment<3>(first(s)) += springForce(x, k, L0, s);
    F.segment<3>(second(s)) -= springForce(x, k, L0, s);
  }
  return F;
});
MUELLE_MISTAKE(triangleForce, interleaved, [](const Vec9& x, const Vec3& k, const Vec3& L0) {
  const Vec9 F = oracle::triangleForce(x, k, L0);
  Vec9 byComponent;
  for (int i = 0; i < 9; ++i) byComponent[i] = F[3 * (i % 3) + i / 3];
  return byComponent;
});
MUELLE_MISTAKE(triangleForce, two_springs, [](const Vec9& x, const Vec3& k, const Vec3& L0) {
  return oracle::triangleForce(x, Vec3(k[0], k[1], 0), L0);
});
MUELLE_MISTAKE(triangleForce, springs_reordered, [](const Vec9& x, const Vec3& k, const Vec3& L0) {
  return oracle::triangleForce(x, reordered(k, in010212), reordered(L0, in010212));
});
MUELLE_MISTAKE(triangleForce, springs_by_opposite_node, [](const Vec9& x, const Vec3& k, const Vec3& L0) {
  return oracle::triangleForce(x, reordered(k, byOppositeNode), reordered(L0, byOppositeNode));
});
MUELLE_MISTAKE(triangleForce, one_rest_length, [](const Vec9& x, const Vec3& k, const Vec3& L0) {
  return oracle::triangleForce(x, k, Vec3(Vec3::Constant(L0[0])));
});
MUELLE_MISTAKE(triangleForce, coincident_stops_all, [](const Vec9& x, const Vec3& k, const Vec3& L0) {
  for (int s = 0; s < 3; ++s) {
    if (length(x, s) == 0) return Vec9(Vec9::Zero());
  }
  return oracle::triangleForce(x, k, L0);
});
MUELLE_MISTAKE(triangleForce, unguarded, [](const Vec9& x, const Vec3& k, const Vec3& L0) {
  Vec9 F = oracle::triangleForce(x, k, L0);
  for (int s = 0; s < 3; ++s) {
    if (length(x, s) > 0) continue;
    F.segment<3>(3 * first(s)).setConstant(std::numeric_limits<double>::quiet_NaN());
    F.segment<3>(3 * second(s)).setConstant(std::numeric_limits<double>::quiet_NaN());
  }
  return F;
});
MUELLE_MISTAKE(triangleForce, threshold, [](const Vec9& x, const Vec3& k, const Vec3& L0) {
  Vec3 felt = k;
  for (int s = 0; s < 3; ++s) {
    if (length(x, s) < threshold) felt[s] = 0;
  }
  return oracle::triangleForce(x, felt, L0);
});
