/// \file
/// What the usual mistakes would return: each is a whole function, so that all calls must agree with it. Those that any
/// function may hold (generic_mistakes.h) are listed where the exercise has better words for them.

#include "triangle.h"

#include "grader/testing/arguments.h"
#include "grader/testing/mistakes.h"

#include <functional>
#include <limits>

namespace {

constexpr int first(int spring) { return spring; }
constexpr int second(int spring) { return (spring + 1) % 3; }

Vec3 difference(const Vec9& x, int spring) {
  return x.segment<3>(3 * first(spring)) - x.segment<3>(3 * second(spring));
}
double lengthOf(const Vec3& d) { return std::hypot(d[0], d[1], d[2]); }
double length(const Vec9& x, int spring) { return lengthOf(difference(x, spring)); }
Vec3 unit(const Vec3& d) {
  const double L = lengthOf(d);
  return L == 0 ? Vec3(Vec3::Zero()) : Vec3(d / L);
}

/// Force of one spring on its first node.
Vec3 springForce(const Vec9& x, const Vec3& k, const Vec3& L0, int spring) {
  return -k[spring] * (length(x, spring) - L0[spring]) * unit(difference(x, spring));
}

/// The values of a vector of the springs in another order: entry s of the result is entry from[s].
Vec3 reordered(const Vec3& values, const std::array<int, 3>& from) {
  return {values[from[0]], values[from[1]], values[from[2]]};
}
constexpr std::array<int, 3> in010212 = {0, 2, 1};        ///< values given for the springs 01, 02, 12
constexpr std::array<int, 3> byOppositeNode = {2, 0, 1};  ///< values given for the springs 12, 20, 01

Vec3 only(const Vec3& values, int spring) { return values[spring] * Vec3::Unit(spring); }
Vec3 without(const Vec3& values, int spring) { return values - only(values, spring); }

/// Adds up forces on the first node of each spring and their opposites on the second, as the solution does.
template <class ForceOfSpring>
Vec9 assembled(const ForceOfSpring& forceOf) {
  Vec9 F = Vec9::Zero();
  for (int s = 0; s < 3; ++s) {
    const Vec3 force = forceOf(s);
    F.segment<3>(3 * first(s)) += force;
    F.segment<3>(3 * second(s)) -= force;
  }
  return F;
}

/// Forces along the springs, of a size that follows from k, L and L0: the tension.
template <class Tension>
Vec9 withTension(const Vec9& x, const Vec3& k, const Vec3& L0, const Tension& tension) {
  return assembled([&](int s) { return Vec3(-tension(k[s], length(x, s), L0[s]) * unit(difference(x, s))); });
}

/// Sum over the springs of what follows from k, L and L0.
template <class Energy>
double summed(const Vec9& x, const Vec3& k, const Vec3& L0, const Energy& energy) {
  double E = 0;
  for (int s = 0; s < 3; ++s) E += energy(k[s], length(x, s), L0[s]);
  return E;
}
double ofStretch(double k, double stretch) { return 0.5 * k * stretch * stretch; }
double rightEnergy(double k, double L, double L0) { return ofStretch(k, L - L0); }

}  // namespace

// --- mass matrix ----------------------------------------------------------------------------------------------------

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
MUELLE_MISTAKE(massMatrix, full_blocks, [](const Vec3& m) {
  Mat9 M = Mat9::Zero();
  for (int i = 0; i < 3; ++i) M.block<3, 3>(3 * i, 3 * i).setConstant(m[i]);
  return M;
});
MUELLE_MISTAKE(massMatrix, mean_mass, [](const Vec3& m) { return oracle::massMatrix(Vec3::Constant(m.sum() / 3)); });
MUELLE_MISTAKE(massMatrix, one_mass, [](const Vec3& m) { return oracle::massMatrix(Vec3::Constant(m[0])); });
MUELLE_MISTAKE(massMatrix, masses_exchanged, [](const Vec3& m) { return oracle::massMatrix(Vec3(m[0], m[2], m[1])); });
MUELLE_MISTAKE(massMatrix, last_skipped, [](const Vec3& m) {
  Mat9 M = oracle::massMatrix(m);
  M(8, 8) = 0;
  return M;
});

// --- energy ---------------------------------------------------------------------------------------------------------

#define ENERGY_MISTAKE(id, ...)      \
  MUELLE_MISTAKE(triangleEnergy, id, \
                 [](const Vec9& x, const Vec3& k, const Vec3& L0) { return summed(x, k, L0, __VA_ARGS__); })

MUELLE_COMMON_MISTAKE(triangleEnergy, missing_half);
ENERGY_MISTAKE(missing_rest_length, [](double ks, double L, double) { return ofStretch(ks, L); });
ENERGY_MISTAKE(difference_of_squares, [](double ks, double L, double l0) { return 0.5 * ks * (L * L - l0 * l0); });
ENERGY_MISTAKE(not_squared, [](double ks, double L, double l0) { return 0.5 * ks * (L - l0); });
ENERGY_MISTAKE(rope, [](double ks, double L, double l0) { return ofStretch(ks, std::max(L - l0, 0.0)); });
ENERGY_MISTAKE(energy_lost_when_coincident,
               [](double ks, double L, double l0) { return L > 0 ? rightEnergy(ks, L, l0) : 0.0; });
ENERGY_MISTAKE(energy_swapped, [](double ks, double L, double l0) { return ofStretch(l0, L - ks); });
MUELLE_MISTAKE(triangleEnergy, whole_numbers, [](const Vec9& x, const Vec3& k, const Vec3& L0) {
  double E = 0;
  for (int s = 0; s < 3; ++s) E = std::trunc(E + rightEnergy(k[s], length(x, s), L0[s]));
  return E;
});
MUELLE_MISTAKE(triangleEnergy, missing_component, [](const Vec9& x, const Vec3& k, const Vec3& L0) {
  Vec9 flat = x;
  for (int i = 0; i < 3; ++i) flat[3 * i + 2] = 0;
  return oracle::triangleEnergy(flat, k, L0);
});
MUELLE_MISTAKE(triangleEnergy, distances_to_origin, [](const Vec9& x, const Vec3& k, const Vec3& L0) {
  double E = 0;
  for (int s = 0; s < 3; ++s) {
    const double from = lengthOf(x.segment<3>(3 * first(s))), to = lengthOf(x.segment<3>(3 * second(s)));
    E += ofStretch(k[s], std::abs(from - to) - L0[s]);
  }
  return E;
});
MUELLE_MISTAKE(triangleEnergy, wrong_block, [](const Vec9& x, const Vec3& k, const Vec3& L0) {
  double E = 0;
  for (int s = 0; s < 3; ++s) {
    E += rightEnergy(k[s], lengthOf(x.segment<3>(first(s)) - x.segment<3>(second(s))), L0[s]);
  }
  return E;
});
MUELLE_MISTAKE(triangleEnergy, overwrites,
               [](const Vec9& x, const Vec3& k, const Vec3& L0) { return oracle::triangleEnergy(x, only(k, 2), L0); });
MUELLE_MISTAKE(triangleEnergy, first_only,
               [](const Vec9& x, const Vec3& k, const Vec3& L0) { return oracle::triangleEnergy(x, only(k, 0), L0); });

// --- force ----------------------------------------------------------------------------------------------------------

#define FORCE_MISTAKE(id, ...)      \
  MUELLE_MISTAKE(triangleForce, id, \
                 [](const Vec9& x, const Vec3& k, const Vec3& L0) { return withTension(x, k, L0, __VA_ARGS__); })

MUELLE_COMMON_MISTAKE(triangleForce, wrong_sign);
MUELLE_COMMON_MISTAKE(triangleForce, half_kept);
MUELLE_MISTAKE(triangleForce, doubled,
               [](const Vec9& x, const Vec3& k, const Vec3& L0) { return Vec9(2 * oracle::triangleForce(x, k, L0)); });
FORCE_MISTAKE(missing_rest_length, [](double ks, double L, double) { return ks * L; });
FORCE_MISTAKE(not_normalised, [](double ks, double L, double l0) { return ks * (L - l0) * L; });
FORCE_MISTAKE(gradient_of_squared_length, [](double ks, double L, double l0) { return 2 * ks * (L - l0) * L; });
FORCE_MISTAKE(absolute_value, [](double ks, double L, double l0) { return ks * std::abs(L - l0); });
FORCE_MISTAKE(rope, [](double ks, double L, double l0) { return ks * std::max(L - l0, 0.0); });
FORCE_MISTAKE(energy_for_force, [](double ks, double L, double l0) { return rightEnergy(ks, L, l0); });
FORCE_MISTAKE(zero_rest_length_skipped, [](double ks, double L, double l0) { return l0 > 0 ? ks * (L - l0) : 0.0; });
FORCE_MISTAKE(whole_numbers, [](double ks, double L, double l0) { return std::trunc(ks) * (L - l0); });

MUELLE_MISTAKE(triangleForce, overwrites, [](const Vec9& x, const Vec3& k, const Vec3& L0) {
  Vec9 F = Vec9::Zero();
  for (int s = 0; s < 3; ++s) {
    F.segment<3>(3 * first(s)) = springForce(x, k, L0, s);
    F.segment<3>(3 * second(s)) = -springForce(x, k, L0, s);
  }
  return F;
});
namespace coincident_left {
MUELLE_MISTAKE(triangleForce, overwrites, [](const Vec9& x, const Vec3& k, const Vec3& L0) {
  Vec9 F = Vec9::Zero();
  for (int s = 0; s < 3; ++s) {
    if (length(x, s) == 0.0) continue;
    F.segment<3>(3 * first(s)) = springForce(x, k, L0, s);
    F.segment<3>(3 * second(s)) = -springForce(x, k, L0, s);
  }
  return F;
});
}  // namespace coincident_left
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
MUELLE_MISTAKE(triangleForce, closing_spring_reversed, [](const Vec9& x, const Vec3& k, const Vec3& L0) {
  return oracle::triangleForce(x, Vec3(k[0], k[1], -k[2]), L0);
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
MUELLE_MISTAKE(triangleForce, stiffness_by_node, [](const Vec9& x, const Vec3& k, const Vec3& L0) {
  Vec9 F = Vec9::Zero();
  for (int s = 0; s < 3; ++s) {
    F.segment<3>(3 * first(s)) += springForce(x, k, L0, s);
    F.segment<3>(3 * second(s)) -= springForce(x, Vec3::Constant(k[second(s)]), L0, s);
  }
  return F;
});
MUELLE_MISTAKE(triangleForce, missing_component, [](const Vec9& x, const Vec3& k, const Vec3& L0) {
  Vec9 F = oracle::triangleForce(x, k, L0);
  for (int i = 0; i < 3; ++i) F[3 * i + 2] = 0;
  return F;
});
MUELLE_MISTAKE(triangleForce, absolute_direction, [](const Vec9& x, const Vec3& k, const Vec3& L0) {
  return assembled([&](int s) { return Vec3(-k[s] * (length(x, s) - L0[s]) * unit(difference(x, s)).cwiseAbs()); });
});
namespace from_first_to_second {
MUELLE_MISTAKE(triangleForce, absolute_direction, [](const Vec9& x, const Vec3& k, const Vec3& L0) {
  return assembled([&](int s) { return Vec3(k[s] * (length(x, s) - L0[s]) * unit(difference(x, s)).cwiseAbs()); });
});
}
MUELLE_MISTAKE(triangleForce, one_coordinate_equal, [](const Vec9& x, const Vec3& k, const Vec3& L0) {
  return assembled([&](int s) { return difference(x, s)[0] == 0 ? Vec3(Vec3::Zero()) : springForce(x, k, L0, s); });
});

// --- springs paired wrongly, in both --------------------------------------------------------------------------------

#define PAIRING_MISTAKE(id, stiffnesses, restLengths)                                   \
  MUELLE_MISTAKE(triangleEnergy, id, [](const Vec9& x, const Vec3& k, const Vec3& L0) { \
    return oracle::triangleEnergy(x, Vec3(stiffnesses(k)), Vec3(restLengths(L0)));      \
  });                                                                                   \
  MUELLE_MISTAKE(triangleForce, id, [](const Vec9& x, const Vec3& k, const Vec3& L0) {  \
    return oracle::triangleForce(x, Vec3(stiffnesses(k)), Vec3(restLengths(L0)));       \
  })

namespace {

Vec3 asGiven(const Vec3& values) { return values; }
Vec3 firstForAll(const Vec3& values) { return Vec3::Constant(values[0]); }
Vec3 withoutFirst(const Vec3& values) { return without(values, 0); }
Vec3 withoutLast(const Vec3& values) { return without(values, 2); }
Vec3 inOtherOrder(const Vec3& values) { return reordered(values, in010212); }
Vec3 ofOppositeNode(const Vec3& values) { return reordered(values, byOppositeNode); }

}  // namespace

PAIRING_MISTAKE(two_springs, withoutLast, asGiven);
PAIRING_MISTAKE(first_skipped, withoutFirst, asGiven);
PAIRING_MISTAKE(springs_reordered, inOtherOrder, inOtherOrder);
PAIRING_MISTAKE(springs_by_opposite_node, ofOppositeNode, ofOppositeNode);
PAIRING_MISTAKE(one_rest_length, asGiven, firstForAll);
PAIRING_MISTAKE(one_stiffness, firstForAll, asGiven);

// --- guards ---------------------------------------------------------------------------------------------------------

MUELLE_MISTAKE(triangleForce, coincident_stops_all, [](const Vec9& x, const Vec3& k, const Vec3& L0) {
  for (int s = 0; s < 3; ++s) {
    if (length(x, s) == 0) return Vec9(Vec9::Zero());
  }
  return oracle::triangleForce(x, k, L0);
});
namespace variants {
MUELLE_MISTAKE(triangleForce, coincident_stops_all, [](const Vec9& x, const Vec3& k, const Vec3& L0) {
  Vec3 felt = Vec3::Zero();
  for (int s = 0; s < 3 && length(x, s) > 0; ++s) felt[s] = k[s];
  return oracle::triangleForce(x, felt, L0);
});
}  // namespace variants

namespace {

using ForceRegistration = muelle::grader::MistakeRegistration<decltype(::triangleForce)>;
using EnergyRegistration = muelle::grader::MistakeRegistration<decltype(::triangleEnergy)>;

/// What a student's guard against L = 0 may compare with or add; each spoils other calls with short springs.
constexpr double smallNumbers[] = {0.1,
                                   1e-2,
                                   1e-3,
                                   1e-4,
                                   1e-5,
                                   1e-6,
                                   1e-7,
                                   1e-8,
                                   1e-9,
                                   1e-10,
                                   1e-11,
                                   1e-12,
                                   1e-13,
                                   1e-14,
                                   1e-15,
                                   1e-16,
                                   std::numeric_limits<double>::epsilon(),
                                   1e-17,
                                   1e-18,
                                   1e-20,
                                   1e-30,
                                   1e-40,
                                   1e-50,
                                   1e-60,
                                   1e-80};

struct Guards {
  std::vector<ForceRegistration> forces;
  std::vector<EnergyRegistration> energies;

  template <class Direction>
  void add(const char* id, Direction directionOf) {
    forces.emplace_back(
        "triangleForce", id, &oracle::triangleForce, [directionOf](const Vec9& x, const Vec3& k, const Vec3& L0) {
          return assembled([&](int s) { return Vec3(-k[s] * (length(x, s) - L0[s]) * directionOf(difference(x, s))); });
        });
  }

  void addSmall(double small) {
    add("threshold", [small](const Vec3& d) { return lengthOf(d) < small ? Vec3(Vec3::Zero()) : unit(d); });
    add("softened_length", [small](const Vec3& d) { return Vec3(d / (lengthOf(d) + small)); });
    add("softened_length", [small](const Vec3& d) { return Vec3(d / std::hypot(lengthOf(d), small)); });
    energies.emplace_back("triangleEnergy", "energy_lost_when_coincident", &oracle::triangleEnergy,
                          [small](const Vec9& x, const Vec3& k, const Vec3& L0) {
                            return summed(x, k, L0, [small](double ks, double L, double l0) {
                              return L < small ? 0.0 : rightEnergy(ks, L, l0);
                            });
                          });
  }

  /// Central differences of the energy with a step h.
  void addQuotient(double h) {
    forces.emplace_back("triangleForce", "difference_quotient", &oracle::triangleForce,
                        [h](const Vec9& x, const Vec3& k, const Vec3& L0) {
                          Vec9 F;
                          for (int i = 0; i < 9; ++i) {
                            const Vec9 step = h * Vec9::Unit(i);
                            F[i] = (oracle::triangleEnergy(x - step, k, L0) - oracle::triangleEnergy(x + step, k, L0)) /
                                   (2 * h);
                          }
                          return F;
                        });
  }

  /// Nodes that are nearer than a part of their distance from the origin are taken for one, as isApprox does.
  void addRelative(double part) {
    forces.emplace_back("triangleForce", "threshold", &oracle::triangleForce,
                        [part](const Vec9& x, const Vec3& k, const Vec3& L0) {
                          Vec3 felt = k;
                          for (int s = 0; s < 3; ++s) {
                            const Vec3 a = x.segment<3>(3 * first(s)), b = x.segment<3>(3 * second(s));
                            if (a.isApprox(b, part)) felt[s] = 0;
                          }
                          return oracle::triangleForce(x, felt, L0);
                        });
  }

  /// The stretch is cut off at some multiple of L0.
  void addClamped(double multiple) {
    forces.emplace_back("triangleForce", "stretch_clamped", &oracle::triangleForce,
                        [multiple](const Vec9& x, const Vec3& k, const Vec3& L0) {
                          return withTension(x, k, L0, [multiple](double ks, double L, double l0) {
                            return ks * std::min(L - l0, multiple * l0);
                          });
                        });
  }

  /// \param bare the springs without a guard
  void addUnguarded(const std::vector<int>& bare) {
    forces.emplace_back("triangleForce", "unguarded", &oracle::triangleForce,
                        [bare](const Vec9& x, const Vec3& k, const Vec3& L0) {
                          Vec9 F = oracle::triangleForce(x, k, L0);
                          for (const int s : bare) {
                            if (length(x, s) > 0) continue;
                            F.segment<3>(3 * first(s)).setConstant(std::numeric_limits<double>::quiet_NaN());
                            F.segment<3>(3 * second(s)).setConstant(std::numeric_limits<double>::quiet_NaN());
                          }
                          return F;
                        });
  }
};

Guards registerGuards() {
  Guards guards;
  for (const double small : smallNumbers) guards.addSmall(small);
  for (const std::vector<int>& bare : {std::vector{0, 1, 2}, {0}, {1}, {2}, {0, 1}, {1, 2}}) guards.addUnguarded(bare);
  for (const double h : {1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7}) guards.addQuotient(h);
  for (const double part : {1e-12, 1e-10, 1e-9, 1e-8, 1e-6}) guards.addRelative(part);
  for (const double multiple : {0.5, 1.0, 2.0}) guards.addClamped(multiple);
  return guards;
}

[[maybe_unused]] const Guards guards = registerGuards();

}  // namespace

// ------------------------------------------------------------------------------------------- arguments in general
// position

namespace {

using muelle::Random;
using muelle::threeDigits;

/// Far longer than any rest length: what does not push, or takes whole numbers, answers to each argument, too.
Vec9 farNodes(Random& random) {
  const Mat3 rotation = random.rotation();
  Vec9 x;
  for (int i = 0; i < 3; ++i) {
    const double angle = 2 * M_PI * i / 3;
    const Vec3 corner = rotation * Vec3(850 * std::cos(angle), 850 * std::sin(angle), 0);
    x.segment<3>(3 * i) = threeDigits(Vec3(corner + random.vector3(40.0)));
  }
  return x;
}

Vec3 threeNumbers(Random& random, double least, double most) {
  const double a = random.rounded(least, most), b = random.rounded(least, most), c = random.rounded(least, most);
  return {a, b, c};
}

}  // namespace

MUELLE_ARGUMENTS(massMatrix, [](Random& random) {
  const Vec3 m = threeNumbers(random, 1.1, 90.0);
  return std::tuple(m);
});

MUELLE_ARGUMENTS(triangleEnergy, [](Random& random) {
  const Vec9 x = farNodes(random);
  const Vec3 k = threeNumbers(random, 20.0, 2000.0), L0 = threeNumbers(random, 2.0, 900.0);
  return std::tuple(x, k, L0);
});

MUELLE_ARGUMENTS(triangleForce, [](Random& random) {
  const Vec9 x = farNodes(random);
  const Vec3 k = threeNumbers(random, 20.0, 2000.0), L0 = threeNumbers(random, 2.0, 900.0);
  return std::tuple(x, k, L0);
});
