#include "spring_1d.h"

#include "grader/testing/arguments.h"
#include "grader/testing/mistakes.h"

#include <algorithm>
#include <limits>

// A mistake in the spring's force shows in every function that uses it, so each is registered for all four of them.

namespace {

/// Minus the product of the lecture's three factors, any of which a mistake may spoil.
double force(double stiffness, double deformation, double direction) { return -stiffness * deformation * direction; }

/// +1 when a is above b, -1 when below.
double direction(double xa, double xb) { return xa > xb ? 1.0 : xa < xb ? -1.0 : 0.0; }

double wrongSign(double xa, double xb, double k, double L0) { return -oracle::springForceOnA(xa, xb, k, L0); }

double missingRestLength(double xa, double xb, double k, double) {
  return force(k, std::abs(xa - xb), direction(xa, xb));
}

double notNormalised(double xa, double xb, double k, double L0) { return force(k, std::abs(xa - xb) - L0, xa - xb); }

double missingDirection(double xa, double xb, double k, double L0) { return force(k, std::abs(xa - xb) - L0, 1.0); }

double signedLength(double xa, double xb, double k, double L0) { return force(k, xa - xb - L0, 1.0); }

/// A direction is made up where there is none.
double forceAtZeroLength(double xa, double xb, double k, double L0) {
  return force(k, std::abs(xa - xb) - L0, xa >= xb ? 1.0 : -1.0);
}

double missingGuard(double xa, double xb, double k, double L0) {
  return xa == xb ? std::numeric_limits<double>::quiet_NaN() : oracle::springForceOnA(xa, xb, k, L0);
}

double relativeDeformation(double xa, double xb, double k, double L0) {
  return xa == xb ? 0.0 : force(k, (std::abs(xa - xb) - L0) / L0, direction(xa, xb));
}

double rope(double xa, double xb, double k, double L0) {
  return force(k, std::max(std::abs(xa - xb) - L0, 0.0), direction(xa, xb));
}

double deformationSquared(double xa, double xb, double k, double L0) {
  return force(k, std::pow(std::abs(xa - xb) - L0, 2), direction(xa, xb));
}

double lengthSquared(double xa, double xb, double k, double L0) {
  return xa == xb ? 0.0 : oracle::springForceOnA(xa, xb, k, L0) / std::abs(xa - xb);
}

/// The signed length, and the direction besides.
double signedLengthTurned(double xa, double xb, double k, double L0) {
  return force(k, xa - xb - L0, direction(xa, xb));
}

/// As if the node hung below its anchor always.
double belowAlways(double xa, double xb, double k, double L0) { return force(k, xb - xa - L0, -1.0); }

double alwaysAttracts(double xa, double xb, double k, double L0) {
  return force(k, std::abs(std::abs(xa - xb) - L0), direction(xa, xb));
}

double missingStiffness(double xa, double xb, double, double L0) { return oracle::springForceOnA(xa, xb, 1.0, L0); }

/// What an author of this mistake returns for L = 0 is guarded or not.
double energyForForce(double xa, double xb, double k, double L0) { return k * std::pow(std::abs(xa - xb) - L0, 2) / 2; }

double guardedEnergy(double xa, double xb, double k, double L0) {
  return xa == xb ? 0.0 : energyForForce(xa, xb, k, L0);
}

double halved(double xa, double xb, double k, double L0) { return oracle::springForceOnA(xa, xb, k / 2, L0); }

}  // namespace

#define SPRING_MISTAKE(id, forceOnA)                                                                                \
  MUELLE_MISTAKE(springForceOnA, id, forceOnA);                                                                     \
  MUELLE_MISTAKE(springForceOnB, id,                                                                                \
                 [](double xa, double xb, double k, double L0) { return -forceOnA(xa, xb, k, L0); });               \
  MUELLE_MISTAKE(hangingAcceleration, id, [](double x, double m, const Attachment& top, double g) {                 \
    return forceOnA(x, top.x, top.k, top.L0) / m - g;                                                               \
  });                                                                                                               \
  MUELLE_MISTAKE(                                                                                                   \
      accelerationBetween, id, [](double x, double m, const Attachment& lower, const Attachment& upper, double g) { \
        const double total = forceOnA(x, lower.x, lower.k, lower.L0) + forceOnA(x, upper.x, upper.k, upper.L0);     \
        return total / m - g;                                                                                       \
      })

SPRING_MISTAKE(wrong_sign, wrongSign);
SPRING_MISTAKE(missing_rest_length, missingRestLength);
SPRING_MISTAKE(not_normalised, notNormalised);
SPRING_MISTAKE(missing_direction, missingDirection);
SPRING_MISTAKE(signed_length, signedLength);
SPRING_MISTAKE(missing_guard, missingGuard);
SPRING_MISTAKE(relative_deformation, relativeDeformation);
SPRING_MISTAKE(always_attracts, alwaysAttracts);
SPRING_MISTAKE(missing_stiffness, missingStiffness);
SPRING_MISTAKE(halved, halved);
SPRING_MISTAKE(force_at_zero_length, forceAtZeroLength);
SPRING_MISTAKE(energy_for_force, energyForForce);
SPRING_MISTAKE(rope, rope);
SPRING_MISTAKE(deformation_squared, deformationSquared);
SPRING_MISTAKE(length_squared, lengthSquared);

namespace variant {
SPRING_MISTAKE(signed_length, signedLengthTurned);
}
namespace hanging {
MUELLE_MISTAKE(hangingAcceleration, signed_length, [](double x, double m, const Attachment& top, double g) {
  return belowAlways(x, top.x, top.k, top.L0) / m - g;
});
MUELLE_MISTAKE(accelerationBetween, signed_length,
               [](double x, double m, const Attachment& lower, const Attachment& upper, double g) {
                 const double up = belowAlways(x, upper.x, upper.k, upper.L0);
                 return (up + signedLength(x, lower.x, lower.k, lower.L0)) / m - g;
               });
}  // namespace hanging

// Without the quotient (xa - xb) / L nothing is divided by 0; an author may treat L = 0 all the same.
namespace guarded {

double missingDirection(double xa, double xb, double k, double L0) {
  return xa == xb ? 0.0 : ::missingDirection(xa, xb, k, L0);
}

double signedLength(double xa, double xb, double k, double L0) {
  return xa == xb ? 0.0 : ::signedLength(xa, xb, k, L0);
}

SPRING_MISTAKE(missing_direction, missingDirection);
SPRING_MISTAKE(signed_length, signedLength);
SPRING_MISTAKE(energy_for_force, guardedEnergy);

}  // namespace guarded

namespace {

using ForceRegistration = muelle::grader::MistakeRegistration<decltype(::springForceOnA)>;

/// What a student's guard against L = 0 may compare with or add; each spoils other calls of the test of short springs.
constexpr double smallNumbers[] = {
    1e-2,  1e-3,  1e-4,  1e-5,  1e-6,  1e-7,  1e-8,  1e-9,
    1e-10, 1e-11, 1e-12, 1e-13, 1e-14, 1e-15, 1e-16, std::numeric_limits<double>::epsilon(),
    1e-17, 1e-18, 1e-20, 1e-30, 1e-40, 1e-50};

double forceWithThreshold(double threshold, double xa, double xb, double k, double L0) {
  return std::abs(xa - xb) < threshold ? 0.0 : oracle::springForceOnA(xa, xb, k, L0);
}

/// Positions that agree in so many digits are taken for equal.
double forceOfUnequal(double relative, double xa, double xb, double k, double L0) {
  const double larger = std::max(std::abs(xa), std::abs(xb));
  return std::abs(xa - xb) <= relative * larger ? 0.0 : oracle::springForceOnA(xa, xb, k, L0);
}

double forceBeyondPart(double part, double xa, double xb, double k, double L0) {
  return std::abs(xa - xb) <= part * L0 ? 0.0 : oracle::springForceOnA(xa, xb, k, L0);
}

double forceSoftened(double small, double xa, double xb, double k, double L0) {
  const double L = std::abs(xa - xb);
  return force(k, L - L0, (xa - xb) / (L + small));
}

double forceOfRoot(double small, double xa, double xb, double k, double L0) {
  const double L = std::hypot(xa - xb, small);
  return force(k, L - L0, (xa - xb) / L);
}

template <class Force>
void addGuard(const char* id, Force forceOnA) {
  const ForceRegistration onA("springForceOnA", id, &oracle::springForceOnA, forceOnA);
  const ForceRegistration onB(
      "springForceOnB", id, &oracle::springForceOnB,
      [forceOnA](double xa, double xb, double k, double L0) { return -forceOnA(xa, xb, k, L0); });
  using Hanging = muelle::grader::MistakeRegistration<decltype(::hangingAcceleration)>;
  const Hanging hanging("hangingAcceleration", id, &oracle::hangingAcceleration,
                        [forceOnA](double x, double m, const Attachment& top, double g) {
                          return forceOnA(x, top.x, top.k, top.L0) / m - g;
                        });
  using Between = muelle::grader::MistakeRegistration<decltype(::accelerationBetween)>;
  const Between between("accelerationBetween", id, &oracle::accelerationBetween,
                        [forceOnA](double x, double m, const Attachment& lower, const Attachment& upper, double g) {
                          const double below = forceOnA(x, lower.x, lower.k, lower.L0);
                          return (below + forceOnA(x, upper.x, upper.k, upper.L0)) / m - g;
                        });
}

template <class Force>
auto withNumber(Force forceOnA, double number) {
  return [=](double xa, double xb, double k, double L0) { return forceOnA(number, xa, xb, k, L0); };
}

[[maybe_unused]] const bool guardsAreRegistered = [] {
  for (const double small : smallNumbers) {
    addGuard("threshold", withNumber(forceWithThreshold, small));
    addGuard("threshold", withNumber(forceOfUnequal, small));
    addGuard("threshold", withNumber(forceBeyondPart, small));
    addGuard("softened_length", withNumber(forceSoftened, small));
    addGuard("softened_length", withNumber(forceOfRoot, small));
  }
  return true;
}();

double forceOf(double x, const Attachment& spring) { return oracle::springForceOnA(x, spring.x, spring.k, spring.L0); }

}  // namespace

MUELLE_MISTAKE(lumpedMass, shared_among_springs, [](double M, int n) { return M / (n - 1); });
namespace one_alone {
MUELLE_MISTAKE(lumpedMass, shared_among_springs, [](double M, int n) { return n <= 1 ? M : M / (n - 1); });
}
MUELLE_MISTAKE(lumpedMass, integer_division, [](double M, int n) { return M * (1 / n); });
MUELLE_MISTAKE(lumpedMass, mass_not_shared, [](double M, int) { return M; });
MUELLE_MISTAKE(lumpedMass, mass_multiplied, [](double M, int n) { return M * n; });

#define NODE_MISTAKE(id, accelerationFrom)                                                            \
  MUELLE_MISTAKE(hangingAcceleration, id, [](double x, double m, const Attachment& top, double g) {   \
    return accelerationFrom(forceOf(x, top), m, g);                                                   \
  });                                                                                                 \
  MUELLE_MISTAKE(accelerationBetween, id,                                                             \
                 [](double x, double m, const Attachment& lower, const Attachment& upper, double g) { \
                   return accelerationFrom(forceOf(x, lower) + forceOf(x, upper), m, g);              \
                 })

namespace {

double gravityUp(double force, double m, double g) { return force / m + g; }
double missingGravity(double force, double m, double) { return force / m; }
double weightWithoutMass(double force, double m, double g) { return (force - g) / m; }
double weightTwiceMass(double force, double m, double g) { return force / m - m * g; }
double missingMass(double force, double m, double g) { return force - m * g; }
double onlyGravityIsAcceleration(double force, double, double g) { return force - g; }
double forceTimesMass(double force, double m, double g) { return force * m - g; }
double multipliedByMass(double force, double m, double g) { return (force - m * g) * m; }

}  // namespace

NODE_MISTAKE(gravity_up, gravityUp);
NODE_MISTAKE(missing_gravity, missingGravity);
NODE_MISTAKE(weight_without_mass, weightWithoutMass);
NODE_MISTAKE(weight_not_divided, weightTwiceMass);
NODE_MISTAKE(missing_mass, missingMass);
NODE_MISTAKE(force_not_divided, onlyGravityIsAcceleration);
NODE_MISTAKE(multiplied_by_mass, multipliedByMass);
namespace of_force {
NODE_MISTAKE(multiplied_by_mass, forceTimesMass);
}

MUELLE_MISTAKE(accelerationBetween, upper_spring_only,
               [](double x, double m, const Attachment&, const Attachment& upper, double g) {
                 return forceOf(x, upper) / m - g;
               });
MUELLE_MISTAKE(accelerationBetween, lower_spring_only,
               [](double x, double m, const Attachment& lower, const Attachment&, double g) {
                 return forceOf(x, lower) / m - g;
               });
MUELLE_MISTAKE(accelerationBetween, springs_subtracted,
               [](double x, double m, const Attachment& lower, const Attachment& upper, double g) {
                 return (forceOf(x, upper) - forceOf(x, lower)) / m - g;
               });
MUELLE_MISTAKE(accelerationBetween, gravity_twice,
               [](double x, double m, const Attachment& lower, const Attachment& upper, double g) {
                 return (forceOf(x, lower) + forceOf(x, upper)) / m - 2 * g;
               });

// A line is copied and not changed everywhere.
MUELLE_MISTAKE(accelerationBetween, same_spring_twice,
               [](double x, double m, const Attachment& lower, const Attachment&, double g) {
                 return 2 * forceOf(x, lower) / m - g;
               });
MUELLE_MISTAKE(accelerationBetween, same_constants_twice,
               [](double x, double m, const Attachment& lower, const Attachment& upper, double g) {
                 return (forceOf(x, lower) + forceOf(x, {upper.x, lower.k, lower.L0})) / m - g;
               });
namespace of_upper {
MUELLE_MISTAKE(accelerationBetween, same_spring_twice,
               [](double x, double m, const Attachment&, const Attachment& upper, double g) {
                 return 2 * forceOf(x, upper) / m - g;
               });
MUELLE_MISTAKE(accelerationBetween, same_constants_twice,
               [](double x, double m, const Attachment& lower, const Attachment& upper, double g) {
                 return (forceOf(x, {lower.x, upper.k, upper.L0}) + forceOf(x, upper)) / m - g;
               });
}  // namespace of_upper

// ------------------------------------------------------------------------------------------- arguments in general
// position

namespace {

using muelle::Random;
using muelle::threeDigits;

struct GeneralSpring {
  double xa, xb, k, L0;
};

/// Stretched or compressed, on either side; so long that something is left of a stretch that is cut to a whole number.
GeneralSpring generalSpring(Random& random) {
  const double xb = random.rounded(-200.0, 200.0), L0 = random.rounded(40.0, 160.0);
  const double L = L0 * random.number(0.3, 1.9);
  const double xa = threeDigits(random.integer(0, 1) == 0 ? xb + L : xb - L);
  return {xa, xb, threeDigits(random.positive(5.0, 500.0)), L0};
}

Attachment generalAttachment(Random& random) {
  return {random.rounded(-300.0, 300.0), threeDigits(random.positive(5.0, 500.0)), random.rounded(40.0, 160.0)};
}

}  // namespace

MUELLE_ARGUMENTS(lumpedMass, [](Random& random) {
  const double M = threeDigits(random.positive(0.1, 50.0));
  const int n = random.integer(2, 40);
  return std::tuple(M, n);
});

MUELLE_ARGUMENTS(springForceOnA, [](Random& random) {
  const auto [xa, xb, k, L0] = generalSpring(random);
  return std::tuple(xa, xb, k, L0);
});

MUELLE_ARGUMENTS(springForceOnB, [](Random& random) {
  const auto [xa, xb, k, L0] = generalSpring(random);
  return std::tuple(xa, xb, k, L0);
});

MUELLE_ARGUMENTS(hangingAcceleration, [](Random& random) {
  const double x = random.rounded(-100.0, 100.0), m = threeDigits(random.positive(0.2, 5.0));
  const double g = random.rounded(1.0, 20.0);
  const Attachment top = generalAttachment(random);
  return std::tuple(x, m, top, g);
});

MUELLE_ARGUMENTS(accelerationBetween, [](Random& random) {
  const double x = random.rounded(-100.0, 100.0), m = threeDigits(random.positive(0.2, 5.0));
  const double g = random.rounded(1.0, 20.0);
  const Attachment lower = generalAttachment(random), upper = generalAttachment(random);
  return std::tuple(x, m, lower, upper, g);
});
