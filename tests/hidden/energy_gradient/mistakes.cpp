/// \file
/// What the usual mistakes would return: each is a whole function, so that all calls must agree with it. Those that any
/// function may hold (generic_mistakes.h) are listed where the exercise has better words for them.

#include "energy_gradient.h"

#include "grader/testing/arguments.h"
#include "grader/testing/mistakes.h"

#include <limits>

namespace {

Vec3 difference(const Vec6& x) { return x.head<3>() - x.tail<3>(); }
double lengthOf(const Vec3& d) { return std::hypot(d[0], d[1], d[2]); }
double length(const Vec6& x) { return lengthOf(difference(x)); }
Vec3 unit(const Vec6& x) { return oracle::lengthGradient(Vec3(x.head<3>()), Vec3(x.tail<3>())); }
Vec6 stacked(const Vec3& a, const Vec3& b) {
  Vec6 both;
  both << a, b;
  return both;
}
Vec6 opposite(const Vec3& a) { return stacked(a, -a); }
double ofStretch(double k, double stretch) { return 0.5 * k * stretch * stretch; }

/// What 0 / 0 leaves where nobody looks at L first.
constexpr double undefined = std::numeric_limits<double>::quiet_NaN();

}  // namespace

// --- energies -------------------------------------------------------------------------------------------------------

MUELLE_MISTAKE(springEnergy1d, signed_length,
               [](const Vec2& x, double k, double L0) { return ofStretch(k, x[0] - x[1] - L0); });
MUELLE_MISTAKE(springEnergy1d, signed_length_reversed,
               [](const Vec2& x, double k, double L0) { return ofStretch(k, x[1] - x[0] - L0); });
MUELLE_MISTAKE(springEnergy1d, absolute_coordinates, [](const Vec2& x, double k, double L0) {
  return ofStretch(k, std::abs(std::abs(x[0]) - std::abs(x[1])) - L0);
});
MUELLE_MISTAKE(springEnergy1d, one_node_only,
               [](const Vec2& x, double k, double L0) { return ofStretch(k, std::abs(x[0]) - L0); });

namespace variants {
MUELLE_MISTAKE(springEnergy1d, one_node_only, [](const Vec2& x, double k, double L0) {
  return ofStretch(k, std::max(std::abs(x[0]), std::abs(x[1])) - L0);
});
MUELLE_MISTAKE(springEnergy1d, signed_length, [](const Vec2& x, double k, double L0) {
  const bool isTurned = x[0] < x[1] && x[0] > 0;
  return ofStretch(k, (isTurned ? x[1] - x[0] : x[0] - x[1]) - L0);
});
}  // namespace variants

/// Mistakes that both energies may hold, as functions of L.
#define ENERGY_MISTAKE(id, ofLength)                                                                         \
  MUELLE_MISTAKE(springEnergy1d, id,                                                                         \
                 [](const Vec2& x, double k, double L0) { return ofLength(std::abs(x[0] - x[1]), k, L0); }); \
  MUELLE_MISTAKE(springEnergy, id, [](const Vec6& x, double k, double L0) { return ofLength(length(x), k, L0); })

namespace {

double missingHalf(double L, double k, double L0) { return 2 * ofStretch(k, L - L0); }
double missingRestLength(double L, double k, double) { return ofStretch(k, L); }
double notSquared(double L, double k, double L0) { return 0.5 * k * (L - L0); }
double notSquaredSize(double L, double k, double L0) { return 0.5 * k * std::abs(L - L0); }
double differenceOfSquares(double L, double k, double L0) { return 0.5 * k * (L * L - L0 * L0); }
double squaredLength(double L, double k, double L0) { return ofStretch(k, L * L - L0); }
double slackWhenCompressed(double L, double k, double L0) { return ofStretch(k, std::max(L - L0, 0.0)); }
double lostWhenCoincident(double L, double k, double L0) { return L > 0 ? ofStretch(k, L - L0) : 0.0; }
double wholeStretch(double L, double k, double L0) { return ofStretch(k, std::trunc(L - L0)); }
double wholeLength(double L, double k, double L0) { return ofStretch(k, std::trunc(L) - L0); }
double unitRestLength(double L, double k, double) { return ofStretch(k, L - 1); }

}  // namespace

ENERGY_MISTAKE(missing_half, missingHalf);
ENERGY_MISTAKE(missing_rest_length, missingRestLength);
ENERGY_MISTAKE(not_squared, notSquared);
ENERGY_MISTAKE(difference_of_squares, differenceOfSquares);
ENERGY_MISTAKE(squared_length, squaredLength);
ENERGY_MISTAKE(rope, slackWhenCompressed);
ENERGY_MISTAKE(energy_lost_when_coincident, lostWhenCoincident);
ENERGY_MISTAKE(whole_numbers, wholeStretch);
ENERGY_MISTAKE(constant_argument, unitRestLength);
namespace variants {
ENERGY_MISTAKE(not_squared, notSquaredSize);
ENERGY_MISTAKE(whole_numbers, wholeLength);
}  // namespace variants

MUELLE_MISTAKE(springEnergy, missing_component, [](const Vec6& x, double k, double L0) {
  return ofStretch(k, std::hypot(x[0] - x[3], x[1] - x[4]) - L0);
});
MUELLE_MISTAKE(springEnergy, distances_to_origin, [](const Vec6& x, double k, double L0) {
  return ofStretch(k, std::abs(lengthOf(x.head<3>()) - lengthOf(x.tail<3>())) - L0);
});
MUELLE_MISTAKE(springEnergy, overlapping_blocks, [](const Vec6& x, double k, double L0) {
  return ofStretch(k, lengthOf(x.head<3>() - x.segment<3>(2)) - L0);
});

// --- the gradient of the length -------------------------------------------------------------------------------------

MUELLE_MISTAKE(lengthGradient, wrong_node_or_sign,
               [](const Vec3& xa, const Vec3& xb) { return oracle::lengthGradient(xb, xa); });
MUELLE_MISTAKE(lengthGradient, not_normalised, [](const Vec3& xa, const Vec3& xb) { return Vec3(xa - xb); });
MUELLE_MISTAKE(lengthGradient, gradient_of_squared_length,
               [](const Vec3& xa, const Vec3& xb) { return Vec3(2 * (xa - xb)); });
MUELLE_MISTAKE(lengthGradient, divided_by_square, [](const Vec3& xa, const Vec3& xb) {
  const double L = lengthOf(xa - xb);
  return L == 0 ? Vec3(Vec3::Zero()) : Vec3((xa - xb) / L / L);
});
MUELLE_MISTAKE(lengthGradient, sum_of_sides, [](const Vec3& xa, const Vec3& xb) {
  const double sum = (xa - xb).lpNorm<1>();
  return sum == 0 ? Vec3(Vec3::Zero()) : Vec3((xa - xb) / sum);
});
MUELLE_MISTAKE(lengthGradient, one_coordinate_equal, [](const Vec3& xa, const Vec3& xb) {
  return xa[0] == xb[0] ? Vec3(Vec3::Zero()) : oracle::lengthGradient(xa, xb);
});
namespace variants {
MUELLE_MISTAKE(lengthGradient, one_coordinate_equal, [](const Vec3& xa, const Vec3& xb) {
  return (xa - xb).prod() == 0 ? Vec3(Vec3::Zero()) : oracle::lengthGradient(xa, xb);
});
}  // namespace variants
MUELLE_MISTAKE(lengthGradient, made_up_direction, [](const Vec3& xa, const Vec3& xb) {
  return xa == xb ? Vec3(Vec3::UnitX()) : oracle::lengthGradient(xa, xb);
});
MUELLE_MISTAKE(lengthGradient, unguarded, [](const Vec3& xa, const Vec3& xb) {
  return xa == xb ? Vec3(Vec3::Constant(undefined)) : oracle::lengthGradient(xa, xb);
});

// --- the gradient of the energy, and the forces ---------------------------------------------------------------------

/// Mistakes that the gradient and the forces may hold; the forces with the other sign.
#define GRADIENT_MISTAKE(id, gradientWith)          \
  MUELLE_MISTAKE(energyGradient, id, gradientWith); \
  MUELLE_MISTAKE(springForces, id,                  \
                 [](const Vec6& x, double k, double L0) { return Vec6(-1.0 * gradientWith(x, k, L0)); })

namespace {

Vec6 otherSign(const Vec6& x, double k, double L0) { return -oracle::energyGradient(x, k, L0); }
Vec6 oneBlock(const Vec6& x, double k, double L0) {
  return stacked(oracle::energyGradient(x, k, L0).head<3>(), Vec3::Zero());
}
Vec6 sameBlock(const Vec6& x, double k, double L0) {
  const Vec3 a = oracle::energyGradient(x, k, L0).head<3>();
  return stacked(a, a);
}
Vec6 oppositeBlock(const Vec6& x, double k, double L0) { return -sameBlock(x, k, L0); }
Vec6 notNormalised(const Vec6& x, double k, double L0) { return opposite(k * (length(x) - L0) * difference(x)); }
Vec6 withoutRestLength(const Vec6& x, double k, double) { return opposite(k * difference(x)); }
Vec6 halfKept(const Vec6& x, double k, double L0) { return 0.5 * oracle::energyGradient(x, k, L0); }
Vec6 gradientDoubled(const Vec6& x, double k, double L0) { return 2 * oracle::energyGradient(x, k, L0); }
Vec6 squaredLengths(const Vec6& x, double k, double L0) { return opposite(2 * k * (length(x) - L0) * difference(x)); }
Vec6 notDifferentiated(const Vec6& x, double k, double L0) {
  return opposite(oracle::springEnergy(x, k, L0) * unit(x));
}
Vec6 alwaysPulls(const Vec6& x, double k, double L0) { return opposite(k * std::abs(length(x) - L0) * unit(x)); }
Vec6 neverPushes(const Vec6& x, double k, double L0) { return opposite(k * std::max(length(x) - L0, 0.0) * unit(x)); }
Vec6 stackedByAxes(const Vec6& x, double k, double L0) {
  const Vec6 gradient = oracle::energyGradient(x, k, L0);
  Vec6 mixed;
  for (int i = 0; i < 3; ++i) mixed.segment<2>(2 * i) << gradient[i], gradient[3 + i];
  return mixed;
}
Vec6 zeroRestLengthIgnored(const Vec6& x, double k, double L0) {
  return L0 == 0 ? Vec6(Vec6::Zero()) : oracle::energyGradient(x, k, L0);
}
Vec6 withoutGuard(const Vec6& x, double k, double L0) {
  return length(x) == 0 ? Vec6(Vec6::Constant(undefined)) : oracle::energyGradient(x, k, L0);
}

}  // namespace

GRADIENT_MISTAKE(wrong_node_or_sign, otherSign);
GRADIENT_MISTAKE(one_block_only, oneBlock);
GRADIENT_MISTAKE(same_block_twice, sameBlock);
GRADIENT_MISTAKE(not_normalised, notNormalised);
GRADIENT_MISTAKE(missing_rest_length, withoutRestLength);
GRADIENT_MISTAKE(half_kept, halfKept);
GRADIENT_MISTAKE(doubled, gradientDoubled);
GRADIENT_MISTAKE(gradient_of_squared_length, squaredLengths);
GRADIENT_MISTAKE(not_differentiated, notDifferentiated);
GRADIENT_MISTAKE(absolute_value, alwaysPulls);
GRADIENT_MISTAKE(rope, neverPushes);
GRADIENT_MISTAKE(stacked_by_axes, stackedByAxes);
GRADIENT_MISTAKE(zero_rest_length_ignored, zeroRestLengthIgnored);
GRADIENT_MISTAKE(unguarded, withoutGuard);
namespace variants {
GRADIENT_MISTAKE(same_block_twice, oppositeBlock);
}  // namespace variants

MUELLE_MISTAKE(springForces, multiplied_for_divided, [](const Vec6& x, double k, double L0) {
  return opposite(-k * (length(x) - L0) * length(x) * difference(x));
});

// --- guards ---------------------------------------------------------------------------------------------------------

namespace {

using DirectionRegistration = muelle::grader::MistakeRegistration<decltype(::lengthGradient)>;
using GradientRegistration = muelle::grader::MistakeRegistration<decltype(::energyGradient)>;
using EnergyRegistration = muelle::grader::MistakeRegistration<decltype(::springEnergy)>;

/// What a student's guard against L = 0 may compare with or add; each spoils other calls with short springs.
constexpr double smallNumbers[] = {
    1e-2,  1e-3,  1e-4,  1e-5,  1e-6,  1e-7,  1e-8,  1e-9,
    1e-10, 1e-11, 1e-12, 1e-13, 1e-14, 1e-15, 1e-16, std::numeric_limits<double>::epsilon(),
    1e-17, 1e-18, 1e-20, 1e-30, 1e-40, 1e-50, 1e-60, 1e-80};

/// What differences of L with a step h give: forward, or central.
Vec3 quotient(const Vec3& d, double h, bool isCentral) {
  Vec3 gradient;
  for (int i = 0; i < 3; ++i) {
    const Vec3 before = isCentral ? Vec3(d - h * Vec3::Unit(i)) : d;
    gradient[i] = (lengthOf(d + h * Vec3::Unit(i)) - lengthOf(before)) / (isCentral ? 2 * h : h);
  }
  return gradient;
}

/// What central differences of the energy with a step h give.
Vec6 energyQuotient(const Vec6& x, double k, double L0, double h) {
  Vec6 gradient;
  for (int i = 0; i < 6; ++i) {
    Vec6 forward = x, backward = x;
    forward[i] += h;
    backward[i] -= h;
    gradient[i] = (oracle::springEnergy(forward, k, L0) - oracle::springEnergy(backward, k, L0)) / (2 * h);
  }
  return gradient;
}

struct Guards {
  std::vector<DirectionRegistration> directions;
  std::vector<GradientRegistration> gradients;
  std::vector<EnergyRegistration> energies;

  /// A mistake of the direction, alone and as it shows in what is built on it.
  template <class Direction>
  void add(const char* id, Direction directionOf) {
    directions.emplace_back("lengthGradient", id, &oracle::lengthGradient,
                            [directionOf](const Vec3& xa, const Vec3& xb) { return Vec3(directionOf(xa - xb)); });
    const auto gradient = [directionOf](const Vec6& x, double k, double L0) {
      return opposite(k * (length(x) - L0) * directionOf(difference(x)));
    };
    gradients.emplace_back("energyGradient", id, &oracle::energyGradient, gradient);
    gradients.emplace_back("springForces", id, &oracle::springForces,
                           [gradient](const Vec6& x, double k, double L0) { return Vec6(-gradient(x, k, L0)); });
  }

  void addThreshold(double small) {
    add("threshold", [small](const Vec3& d) {
      const double L = lengthOf(d);
      return L < small ? Vec3(Vec3::Zero()) : Vec3(d / L);
    });
    energies.emplace_back(
        "springEnergy", "energy_lost_when_coincident", &oracle::springEnergy,
        [small](const Vec6& x, double k, double L0) { return length(x) < small ? 0.0 : ofStretch(k, length(x) - L0); });
    energies.emplace_back("springEnergy", "threshold", &oracle::springEnergy,
                          [small](const Vec6& x, double k, double L0) {
                            const double stretch = length(x) - L0;
                            return std::abs(stretch) < small ? 0.0 : ofStretch(k, stretch);
                          });
  }

  void addQuotients(double h) {
    for (const bool isCentral : {false, true}) {
      directions.emplace_back(
          "lengthGradient", "difference_quotient", &oracle::lengthGradient,
          [h, isCentral](const Vec3& xa, const Vec3& xb) { return quotient(xa - xb, h, isCentral); });
    }
    gradients.emplace_back("energyGradient", "difference_quotient", &oracle::energyGradient,
                           [h](const Vec6& x, double k, double L0) { return energyQuotient(x, k, L0, h); });
    gradients.emplace_back("springForces", "difference_quotient", &oracle::springForces,
                           [h](const Vec6& x, double k, double L0) { return Vec6(-energyQuotient(x, k, L0, h)); });
  }

  /// Nodes that are nearer than a part of their distance from the origin are taken for one, as isApprox does.
  void addRelative(double part) {
    const auto directionOf = [part](const Vec3& xa, const Vec3& xb) {
      return xa.isApprox(xb, part) ? Vec3(Vec3::Zero()) : oracle::lengthGradient(xa, xb);
    };
    directions.emplace_back("lengthGradient", "threshold", &oracle::lengthGradient, directionOf);
    const auto gradient = [directionOf](const Vec6& x, double k, double L0) {
      return opposite(k * (length(x) - L0) * directionOf(x.head<3>(), x.tail<3>()));
    };
    gradients.emplace_back("energyGradient", "threshold", &oracle::energyGradient, gradient);
    gradients.emplace_back("springForces", "threshold", &oracle::springForces,
                           [gradient](const Vec6& x, double k, double L0) { return Vec6(-gradient(x, k, L0)); });
  }

  /// The stretch is cut off at some multiple of L0.
  void addClamped(double multiple) {
    const auto gradient = [multiple](const Vec6& x, double k, double L0) {
      return opposite(k * std::min(length(x) - L0, multiple * L0) * unit(x));
    };
    gradients.emplace_back("energyGradient", "stretch_clamped", &oracle::energyGradient, gradient);
    gradients.emplace_back("springForces", "stretch_clamped", &oracle::springForces,
                           [gradient](const Vec6& x, double k, double L0) { return Vec6(-gradient(x, k, L0)); });
  }

  void addSoftened(double small) {
    add("softened_length", [small](const Vec3& d) { return Vec3(d / (lengthOf(d) + small)); });
    add("softened_length", [small](const Vec3& d) { return Vec3(d / std::hypot(lengthOf(d), small)); });
  }
};

Guards registerGuards() {
  Guards guards;
  for (const double small : smallNumbers) {
    guards.addThreshold(small);
    guards.addSoftened(small);
  }
  for (const double h : {1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7}) guards.addQuotients(h);
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

Vec3 somewhere(Random& random, double least, double most) {
  return threeDigits(Vec3(random.number(least, most) * random.direction()));
}

/// Far longer than any rest length: what does not push, or takes whole numbers, answers to each argument, too.
constexpr double shortestGeneral = 1200, longestGeneral = 1700;

Vec6 twoNodes(Random& random) {
  const Vec3 half = 0.5 * somewhere(random, shortestGeneral, longestGeneral);
  const Vec3 middle = somewhere(random, 1.0, 100.0);
  return stacked(threeDigits(Vec3(middle + half)), threeDigits(Vec3(middle - half)));
}
double generalStiffness(Random& random) { return threeDigits(random.positive(20.0, 2000.0)); }
double generalRestLength(Random& random) { return random.rounded(2.0, 900.0); }

}  // namespace

MUELLE_ARGUMENTS(springEnergy1d, [](Random& random) {
  const double half = 0.5 * random.number(shortestGeneral, longestGeneral), middle = random.number(-100.0, 100.0);
  const double side = random.integer(0, 1) == 0 ? 1.0 : -1.0;
  const Vec2 x(threeDigits(middle + side * half), threeDigits(middle - side * half));
  const double k = generalStiffness(random), L0 = generalRestLength(random);
  return std::tuple(x, k, L0);
});

MUELLE_ARGUMENTS(springEnergy, [](Random& random) {
  const Vec6 x = twoNodes(random);
  const double k = generalStiffness(random), L0 = generalRestLength(random);
  return std::tuple(x, k, L0);
});

MUELLE_ARGUMENTS(lengthGradient, [](Random& random) {
  const Vec3 xa = somewhere(random, 0.5, 4.0), xb = somewhere(random, 0.5, 4.0);
  return std::tuple(xa, xb);
});

MUELLE_ARGUMENTS(energyGradient, [](Random& random) {
  const Vec6 x = twoNodes(random);
  const double k = generalStiffness(random), L0 = generalRestLength(random);
  return std::tuple(x, k, L0);
});

MUELLE_ARGUMENTS(springForces, [](Random& random) {
  const Vec6 x = twoNodes(random);
  const double k = generalStiffness(random), L0 = generalRestLength(random);
  return std::tuple(x, k, L0);
});
