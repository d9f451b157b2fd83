#include "spring_3d.h"

#include "grader/testing/arguments.h"
#include "grader/testing/mistakes.h"

#include <algorithm>
#include <limits>

namespace {

double lengthOf(const Vec3& xa, const Vec3& xb) { return (xa - xb).norm(); }

const double notANumber = std::numeric_limits<double>::quiet_NaN();

}  // namespace

// springForceMagnitude

MUELLE_COMMON_MISTAKE(springForceMagnitude, wrong_sign);
MUELLE_MISTAKE(springForceMagnitude, unsigned_deformation, [](const Vec3& xa, const Vec3& xb, double k, double L0) {
  return std::abs(oracle::springForceMagnitude(xa, xb, k, L0));
});
namespace both_squared {
MUELLE_MISTAKE(springForceMagnitude, squared_length, [](const Vec3& xa, const Vec3& xb, double k, double L0) {
  return -k * ((xa - xb).squaredNorm() - L0 * L0);
});
}
namespace attracting {
MUELLE_MISTAKE(springForceMagnitude, unsigned_deformation, [](const Vec3& xa, const Vec3& xb, double k, double L0) {
  return -std::abs(oracle::springForceMagnitude(xa, xb, k, L0));
});
}
MUELLE_MISTAKE(springForceMagnitude, missing_rest_length,
               [](const Vec3& xa, const Vec3& xb, double k, double) { return -k * lengthOf(xa, xb); });
MUELLE_MISTAKE(springForceMagnitude, squared_length, [](const Vec3& xa, const Vec3& xb, double k, double L0) {
  return -k * (std::pow(lengthOf(xa, xb), 2) - L0);
});
MUELLE_MISTAKE(springForceMagnitude, relative_deformation, [](const Vec3& xa, const Vec3& xb, double k, double L0) {
  return oracle::springForceMagnitude(xa, xb, k, L0) / L0;
});
// Without a rest length there is no strain: who sees that keeps the plain law there.
namespace guarded_strain {
MUELLE_MISTAKE(springForceMagnitude, relative_deformation, [](const Vec3& xa, const Vec3& xb, double k, double L0) {
  return oracle::springForceMagnitude(xa, xb, k, L0) / (L0 == 0.0 ? 1.0 : L0);
});
}
MUELLE_MISTAKE(springForceMagnitude, length_of_components,
               [](const Vec3& xa, const Vec3& xb, double k, double L0) { return -k * ((xa - xb).lpNorm<1>() - L0); });
namespace largest_component {
MUELLE_MISTAKE(springForceMagnitude, length_of_components, [](const Vec3& xa, const Vec3& xb, double k, double L0) {
  return -k * ((xa - xb).lpNorm<Eigen::Infinity>() - L0);
});
}
MUELLE_MISTAKE(springForceMagnitude, difference_of_norms,
               [](const Vec3& xa, const Vec3& xb, double k, double L0) { return -k * (xa.norm() - xb.norm() - L0); });
namespace either_farther {
MUELLE_MISTAKE(springForceMagnitude, difference_of_norms, [](const Vec3& xa, const Vec3& xb, double k, double L0) {
  return -k * (std::abs(xa.norm() - xb.norm()) - L0);
});
}
MUELLE_COMMON_MISTAKE(springForceMagnitude, halved);
MUELLE_MISTAKE(springForceMagnitude, missing_stiffness, [](const Vec3& xa, const Vec3& xb, double, double L0) {
  return oracle::springForceMagnitude(xa, xb, 1.0, L0);
});
MUELLE_MISTAKE(springForceMagnitude, rope, [](const Vec3& xa, const Vec3& xb, double k, double L0) {
  return -k * std::max(lengthOf(xa, xb) - L0, 0.0);
});
MUELLE_MISTAKE(springForceMagnitude, single_precision, [](const Vec3& xa, const Vec3& xb, double k, double L0) {
  return -k * (static_cast<double>(static_cast<float>(lengthOf(xa, xb))) - L0);
});
MUELLE_MISTAKE(springForceMagnitude, whole_numbers, [](const Vec3& xa, const Vec3& xb, double k, double L0) {
  return -k * (std::trunc(lengthOf(xa, xb)) - L0);
});
MUELLE_MISTAKE(springForceMagnitude, missing_component, [](const Vec3& xa, const Vec3& xb, double k, double L0) {
  return -k * ((xa - xb).head<2>().norm() - L0);
});
MUELLE_MISTAKE(springForceMagnitude, energy_for_force, [](const Vec3& xa, const Vec3& xb, double k, double L0) {
  return k * std::pow(lengthOf(xa, xb) - L0, 2) / 2;
});

// springDirection

MUELLE_COMMON_MISTAKE(springDirection, wrong_sign);
MUELLE_MISTAKE(springDirection, not_normalised, [](const Vec3& xa, const Vec3& xb) { return Vec3(xa - xb); });
MUELLE_MISTAKE(springDirection, squared_length, [](const Vec3& xa, const Vec3& xb) {
  return xa == xb ? Vec3(0, 0, 0) : Vec3((xa - xb) / (xa - xb).squaredNorm());
});
MUELLE_MISTAKE(springDirection, missing_guard, [](const Vec3& xa, const Vec3& xb) {
  return xa == xb ? Vec3(notANumber, notANumber, notANumber) : oracle::springDirection(xa, xb);
});
MUELLE_MISTAKE(springDirection, single_precision, [](const Vec3& xa, const Vec3& xb) {
  const float L = static_cast<float>(lengthOf(xa, xb));
  return L == 0 ? Vec3(0, 0, 0) : Vec3((xa - xb) / static_cast<double>(L));
});
namespace all_single {
MUELLE_MISTAKE(springDirection, single_precision, [](const Vec3& xa, const Vec3& xb) {
  const Eigen::Vector3f r = (xa - xb).cast<float>();
  const float L = r.norm();
  return L == 0 ? Vec3(0, 0, 0) : Vec3((r / L).cast<double>());
});
}
MUELLE_MISTAKE(springDirection, other_end_left_out, [](const Vec3& xa, const Vec3& xb) {
  const double distance = xa.norm();
  return xa == xb || distance == 0 ? Vec3(0, 0, 0) : Vec3(xa / distance);
});

// The force on a, and the acceleration of a node whose springs have that force.

namespace {

Vec3 wrongSign(const Vec3& xa, const Vec3& xb, double k, double L0) { return -oracle::springForce(xa, xb, k, L0); }

Vec3 missingRestLength(const Vec3& xa, const Vec3& xb, double k, double) { return k * (xb - xa); }

Vec3 notNormalised(const Vec3& xa, const Vec3& xb, double k, double L0) {
  return oracle::springForceMagnitude(xa, xb, k, L0) * (xa - xb);
}

Vec3 squaredLengthInDirection(const Vec3& xa, const Vec3& xb, double k, double L0) {
  return xa == xb ? Vec3(0, 0, 0) : Vec3(oracle::springForce(xa, xb, k, L0) / lengthOf(xa, xb));
}

Vec3 squaredLengthInMagnitude(const Vec3& xa, const Vec3& xb, double k, double L0) {
  return -k * ((xa - xb).squaredNorm() - L0) * oracle::springDirection(xa, xb);
}

/// Each axis as if it were the line of the exercise before.
Vec3 eachAxisAlone(const Vec3& xa, const Vec3& xb, double k, double L0) {
  Vec3 force = Vec3::Zero();
  for (int axis = 0; axis < 3; ++axis) {
    const double r = xa[axis] - xb[axis];
    if (r != 0) force[axis] = k * (std::copysign(L0, r) - r);
  }
  return force;
}

Vec3 alwaysAttracts(const Vec3& xa, const Vec3& xb, double k, double L0) {
  return -std::abs(oracle::springForceMagnitude(xa, xb, k, L0)) * oracle::springDirection(xa, xb);
}

Vec3 alwaysRepels(const Vec3& xa, const Vec3& xb, double k, double L0) {
  return std::abs(oracle::springForceMagnitude(xa, xb, k, L0)) * oracle::springDirection(xa, xb);
}

Vec3 rope(const Vec3& xa, const Vec3& xb, double k, double L0) {
  return -k * std::max(lengthOf(xa, xb) - L0, 0.0) * oracle::springDirection(xa, xb);
}

Vec3 relativeDeformation(const Vec3& xa, const Vec3& xb, double k, double L0) {
  return oracle::springForce(xa, xb, k / L0, L0);
}

Vec3 missingStiffness(const Vec3& xa, const Vec3& xb, double, double L0) {
  return oracle::springForce(xa, xb, 1.0, L0);
}

Vec3 halved(const Vec3& xa, const Vec3& xb, double k, double L0) { return oracle::springForce(xa, xb, k / 2, L0); }

Vec3 missingGuard(const Vec3& xa, const Vec3& xb, double k, double L0) {
  return xa == xb ? Vec3(notANumber, notANumber, notANumber) : oracle::springForce(xa, xb, k, L0);
}

template <class Force>
Vec3 sumOf(const Force& forceOnA, const Vec3& x, const std::vector<Attachment>& springs) {
  Vec3 sum = Vec3::Zero();
  for (const Attachment& spring : springs) sum += forceOnA(x, spring.x, spring.k, spring.L0);
  return sum;
}

}  // namespace

#define SPRING_MISTAKE(id, forceOnA)                                                                                   \
  MUELLE_MISTAKE(springForce, id, forceOnA);                                                                           \
  MUELLE_MISTAKE(nodeAcceleration, id, [](const Vec3& x, double m, const std::vector<Attachment>& springs, double g) { \
    return Vec3(sumOf(forceOnA, x, springs) / m - Vec3(0, 0, g));                                                      \
  })

SPRING_MISTAKE(wrong_sign, wrongSign);
SPRING_MISTAKE(missing_rest_length, missingRestLength);
SPRING_MISTAKE(not_normalised, notNormalised);
SPRING_MISTAKE(squared_length, squaredLengthInDirection);
namespace magnitude {
SPRING_MISTAKE(squared_length, squaredLengthInMagnitude);
}
SPRING_MISTAKE(each_axis_alone, eachAxisAlone);
SPRING_MISTAKE(unsigned_deformation, alwaysRepels);
namespace attracting {
SPRING_MISTAKE(unsigned_deformation, alwaysAttracts);
}
SPRING_MISTAKE(rope, rope);
SPRING_MISTAKE(relative_deformation, relativeDeformation);
SPRING_MISTAKE(missing_stiffness, missingStiffness);
SPRING_MISTAKE(halved, halved);
SPRING_MISTAKE(missing_guard, missingGuard);

// Guards against L = 0 that catch too much, or make up a direction.

namespace {

using DirectionRegistration = muelle::grader::MistakeRegistration<decltype(::springDirection)>;
using ForceRegistration = muelle::grader::MistakeRegistration<decltype(::springForce)>;
using AccelerationRegistration = muelle::grader::MistakeRegistration<decltype(::nodeAcceleration)>;

/// What a guard may compare with or add; each spoils other calls of the test of short springs.
constexpr double smallNumbers[] = {
    1e-2,  1e-3,  1e-4,  1e-5,  1e-6,  1e-7,  1e-8,  1e-9,
    1e-10, 1e-11, 1e-12, 1e-13, 1e-14, 1e-15, 1e-16, std::numeric_limits<double>::epsilon(),
    1e-17, 1e-18, 1e-20, 1e-30, 1e-40, 1e-50};

/// Registers a spoiled direction, and the force and the acceleration that come of it.
template <class Direction>
void addDirection(const char* id, Direction direction) {
  const auto forceOnA = [direction](const Vec3& xa, const Vec3& xb, double k, double L0) {
    return Vec3(oracle::springForceMagnitude(xa, xb, k, L0) * direction(xa, xb));
  };
  const auto acceleration = [forceOnA](const Vec3& x, double m, const std::vector<Attachment>& springs, double g) {
    return Vec3(sumOf(forceOnA, x, springs) / m - Vec3(0, 0, g));
  };
  const DirectionRegistration first("springDirection", id, &oracle::springDirection, direction);
  const ForceRegistration second("springForce", id, &oracle::springForce, forceOnA);
  const AccelerationRegistration third("nodeAcceleration", id, &oracle::nodeAcceleration, acceleration);
}

[[maybe_unused]] const bool directionsAreRegistered = [] {
  for (const double small : smallNumbers) {
    addDirection("threshold", [small](const Vec3& xa, const Vec3& xb) {
      return lengthOf(xa, xb) < small ? Vec3(0, 0, 0) : oracle::springDirection(xa, xb);
    });
    addDirection("threshold", [small](const Vec3& xa, const Vec3& xb) {
      const bool taken = lengthOf(xa, xb) <= small * std::min(xa.norm(), xb.norm());
      return taken ? Vec3(0, 0, 0) : oracle::springDirection(xa, xb);
    });
    addDirection("softened_length", [small](const Vec3& xa, const Vec3& xb) {
      return Vec3((xa - xb) / std::hypot(lengthOf(xa, xb), small));
    });
    addDirection("softened_length", [small](const Vec3& xa, const Vec3& xb) {
      return Vec3((xa - xb) / std::max(lengthOf(xa, xb), small));
    });
    addDirection("softened_length",
                 [small](const Vec3& xa, const Vec3& xb) { return Vec3((xa - xb) / (lengthOf(xa, xb) + small)); });
  }
  for (const Vec3& madeUp : {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1), Vec3(1, 1, 1)}) {
    addDirection("direction_at_zero_length", [madeUp](const Vec3& xa, const Vec3& xb) {
      return xa == xb ? madeUp : oracle::springDirection(xa, xb);
    });
  }
  return true;
}();

}  // namespace

// nodeAcceleration

#define NODE_MISTAKE(id, ...)                                                                                          \
  MUELLE_MISTAKE(nodeAcceleration, id, [](const Vec3& x, double m, const std::vector<Attachment>& springs, double g) { \
    const Vec3 force = sumOf(oracle::springForce, x, springs);                                                         \
    const Vec3 up(0, 0, 1);                                                                                            \
    return Vec3(__VA_ARGS__);                                                                                          \
  })

NODE_MISTAKE(gravity_up, force / m + g * up);
NODE_MISTAKE(missing_gravity, force / m + 0 * g * up);
NODE_MISTAKE(weight_without_mass, (force - g * up) / m);
NODE_MISTAKE(weight_not_divided, force / m - m * g * up);
NODE_MISTAKE(missing_mass, force - m * g * up);
NODE_MISTAKE(force_not_divided, force - m / m * g * up);
NODE_MISTAKE(multiplied_by_mass, (force - m * g * up) * m);
namespace forces_alone {
NODE_MISTAKE(multiplied_by_mass, force* m - g * up);
}
NODE_MISTAKE(gravity_along_y, force / m - Vec3(0, g, 0) - 0 * up);
NODE_MISTAKE(gravity_on_every_axis, force / m - Vec3(g, g, g) - 0 * up);
NODE_MISTAKE(gravity_per_spring, force / m - static_cast<double>(springs.size()) * g * up);
namespace weight_of_none {
NODE_MISTAKE(gravity_per_spring, force / m - std::max(1.0, static_cast<double>(springs.size())) * g * up);
}
NODE_MISTAKE(averaged, springs.empty() ? Vec3(-g* up) : Vec3(force / m / static_cast<double>(springs.size()) - g * up));

namespace {

Vec3 forceOf(const Vec3& x, const Attachment& spring) { return oracle::springForce(x, spring.x, spring.k, spring.L0); }

}  // namespace

// = for +=, with the weight added after the loop or lost in it.
MUELLE_MISTAKE(nodeAcceleration, last_spring_only,
               [](const Vec3& x, double m, const std::vector<Attachment>& springs, double g) {
                 const Vec3 force = springs.empty() ? Vec3(0, 0, 0) : forceOf(x, springs.back());
                 return Vec3(force / m - Vec3(0, 0, g));
               });
namespace weight_lost {
MUELLE_MISTAKE(nodeAcceleration, last_spring_only,
               [](const Vec3& x, double m, const std::vector<Attachment>& springs, double g) {
                 return springs.empty() ? Vec3(0, 0, -g) : Vec3(forceOf(x, springs.back()) / m);
               });
}
MUELLE_MISTAKE(nodeAcceleration, first_spring_only,
               [](const Vec3& x, double m, const std::vector<Attachment>& springs, double g) {
                 const Vec3 force = springs.empty() ? Vec3(0, 0, 0) : forceOf(x, springs.front());
                 return Vec3(force / m - Vec3(0, 0, g));
               });

// ------------------------------------------------------------------------------------------- arguments in general
// position

namespace {

using muelle::Random;
using muelle::threeDigits;

struct GeneralSpring {
  Vec3 xa, xb;
  double k, L0;
};

/// Stretched or compressed, in any direction; so long that something is left of a stretch that is cut to a whole
/// number.
GeneralSpring generalSpring(Random& random) {
  const Vec3 xb = threeDigits(random.vector3(200.0));
  const double L0 = random.rounded(40.0, 160.0);
  const Vec3 xa = threeDigits(Vec3(xb + L0 * random.number(0.3, 1.9) * random.direction()));
  return {xa, xb, threeDigits(random.positive(5.0, 500.0)), L0};
}

}  // namespace

MUELLE_ARGUMENTS(springForceMagnitude, [](Random& random) {
  const auto [xa, xb, k, L0] = generalSpring(random);
  return std::tuple(xa, xb, k, L0);
});

MUELLE_ARGUMENTS(springDirection, [](Random& random) {
  const auto [xa, xb, k, L0] = generalSpring(random);
  return std::tuple(xa, xb);
});

MUELLE_ARGUMENTS(springForce, [](Random& random) {
  const auto [xa, xb, k, L0] = generalSpring(random);
  return std::tuple(xa, xb, k, L0);
});

MUELLE_ARGUMENTS(nodeAcceleration, [](Random& random) {
  const Vec3 x = threeDigits(random.vector3(100.0));
  const double m = threeDigits(random.positive(0.2, 5.0)), g = random.rounded(1.0, 20.0);
  std::vector<Attachment> springs;
  for (int i = 0; i < 3; ++i) {
    springs.push_back(
        {threeDigits(random.vector3(300.0)), threeDigits(random.positive(5.0, 500.0)), random.rounded(40.0, 160.0)});
  }
  return std::tuple(x, m, springs, g);
});
