/// \file
/// What the usual mistakes would return: each is a whole function, so that all calls must agree with it. Those that any
/// function may hold (generic_mistakes.h) are listed where the exercise has better words for them.

#include "generalised_springs.h"

#include "grader/testing/arguments.h"
#include "grader/testing/mistakes.h"

#include <Eigen/Geometry>

#include <functional>
#include <limits>

namespace {

double square(double number) { return number * number; }
double norm(const Vec3& d) { return std::hypot(d[0], d[1], d[2]); }

/// Edges and normal of three nodes.
struct Three {
  Vec3 u, w;     ///< x1 - x0 and x2 - x1, the segments of a bend
  Vec3 a, b, c;  ///< x2 - x1, x0 - x2, x1 - x0, the sides opposite to nodes 0, 1, 2
  Vec3 normal;   ///< u x w, twice the area long

  explicit Three(const Vec9& x)
      : u(x.segment<3>(3) - x.segment<3>(0)),
        w(x.segment<3>(6) - x.segment<3>(3)),
        a(w),
        b(x.segment<3>(0) - x.segment<3>(6)),
        c(u),
        normal(u.cross(w)) {}

  double angle() const { return std::atan2(norm(normal), u.dot(w)); }
  double interior() const { return std::atan2(norm(normal), -u.dot(w)); }
  double area() const { return norm(normal) / 2; }
  Vec3 n() const { return normal / norm(normal); }
  bool isFlat() const { return norm(normal) == 0; }
};

Vec9 stacked(const Vec3& x0, const Vec3& x1, const Vec3& x2) {
  Vec9 x;
  x << x0, x1, x2;
  return x;
}

/// Ends pushed at right angles to their segments: by `u` and `w` over the torque.
Vec9 bent(const Three& at, double torque, double u, double w) {
  if (at.isFlat()) return Vec9::Zero();
  const Vec3 first = torque * u * at.n().cross(at.u), last = torque * w * at.n().cross(at.w);
  return stacked(first, -first - last, last);
}
double overU(const Three& at) { return 1 / at.u.squaredNorm(); }
double overW(const Three& at) { return 1 / at.w.squaredNorm(); }

/// The forces of a pressure on the three corners.
Vec9 pressed(const Three& at, double pressure) {
  if (at.isFlat()) return Vec9::Zero();
  const Vec3 n = pressure / 2 * at.n();
  return stacked(n.cross(at.a), n.cross(at.b), n.cross(at.c));
}

struct Four {
  Vec3 a, b, c;

  explicit Four(const Vec12& x)
      : a(x.segment<3>(3) - x.segment<3>(0)),
        b(x.segment<3>(6) - x.segment<3>(0)),
        c(x.segment<3>(9) - x.segment<3>(0)) {}
  double volume() const { return a.cross(b).dot(c) / 6; }
};

Vec12 pushed(const Vec3& on1, const Vec3& on2, const Vec3& on3) {
  Vec12 F;
  F << -on1 - on2 - on3, on1, on2, on3;
  return F;
}
Vec12 pressed(const Four& at, double pressure) {
  const double p = pressure / 6;
  return pushed(p * at.b.cross(at.c), p * at.c.cross(at.a), p * at.a.cross(at.b));
}

constexpr double undefined = std::numeric_limits<double>::quiet_NaN();

}  // namespace

// --- bending --------------------------------------------------------------------------------------------------------

/// A wrong angle, in the function itself and where energy or force have it written out.
#define ANGLE_MISTAKE(id, ...)                                                               \
  MUELLE_MISTAKE(bendingAngle, id, [](const Vec9& x) -> double {                             \
    const Three at(x);                                                                       \
    return __VA_ARGS__;                                                                      \
  });                                                                                        \
  MUELLE_MISTAKE(bendingEnergy, id, [](const Vec9& x, double theta0, double kb) -> double {  \
    const Three at(x);                                                                       \
    return norm(at.u) > 0 && norm(at.w) > 0 ? 0.5 * kb * square((__VA_ARGS__)-theta0) : 0.0; \
  });                                                                                        \
  MUELLE_MISTAKE(bendingForce, id, [](const Vec9& x, double theta0, double kb) -> Vec9 {     \
    const Three at(x);                                                                       \
    return bent(at, -kb * ((__VA_ARGS__)-theta0), overU(at), overW(at));                     \
  })

ANGLE_MISTAKE(interior_angle, at.interior());
ANGLE_MISTAKE(in_degrees, at.angle() * 180 / M_PI);
ANGLE_MISTAKE(cosine_for_angle, at.u.dot(at.w) / (norm(at.u) * norm(at.w)));
ANGLE_MISTAKE(sine_for_angle, norm(at.normal) / (norm(at.u) * norm(at.w)));
ANGLE_MISTAKE(arc_sine, std::asin(std::min(1.0, norm(at.normal) / (norm(at.u) * norm(at.w)))));
// Near rest alone, where the last digits of the cosine decide: each way to compute it is one of its own.
MUELLE_MISTAKE(bendingAngle, arc_cosine, [](const Vec9& x) {
  const Three at(x);
  return std::acos(std::clamp(at.u.dot(at.w) / (at.u.norm() * at.w.norm()), -1.0, 1.0));
});
namespace of_unit_vectors {
MUELLE_MISTAKE(bendingAngle, arc_cosine, [](const Vec9& x) {
  const Three at(x);
  return std::acos(std::clamp(at.u.normalized().dot(at.w.normalized()), -1.0, 1.0));
});
}  // namespace of_unit_vectors
namespace divided_twice {
MUELLE_MISTAKE(bendingAngle, arc_cosine, [](const Vec9& x) {
  const Three at(x);
  return std::acos(std::clamp(at.u.dot(at.w) / at.u.norm() / at.w.norm(), -1.0, 1.0));
});
}  // namespace divided_twice
ANGLE_MISTAKE(angle_at_node_0, std::atan2(norm(at.normal), at.u.dot(-at.b)));
ANGLE_MISTAKE(tangent_for_angle, norm(at.normal) / at.u.dot(at.w));
ANGLE_MISTAKE(not_normalised, std::acos(std::clamp(at.u.dot(at.w), -1.0, 1.0)));
ANGLE_MISTAKE(arguments_of_atan2, std::atan2(at.u.dot(at.w), norm(at.normal)));
ANGLE_MISTAKE(half_plane, std::atan(norm(at.normal) / at.u.dot(at.w)));

#define BENDING_ENERGY_MISTAKE(id, ...)                                                                      \
  MUELLE_MISTAKE(bendingEnergy, id, [](const Vec9& x, [[maybe_unused]] double theta0, double kb) -> double { \
    const Three at(x);                                                                                       \
    const double angle = at.angle();                                                                         \
    return norm(at.u) > 0 && norm(at.w) > 0 ? __VA_ARGS__ : 0.0;                                             \
  })

MUELLE_COMMON_MISTAKE(bendingEnergy, missing_half);
BENDING_ENERGY_MISTAKE(not_squared, 0.5 * kb * (angle - theta0));
BENDING_ENERGY_MISTAKE(missing_rest, 0.5 * kb * square(angle));
BENDING_ENERGY_MISTAKE(difference_of_squares, 0.5 * kb * (square(angle) - square(theta0)));
BENDING_ENERGY_MISTAKE(cosine_energy, kb*(1 - std::cos(angle - theta0)));
MUELLE_MISTAKE(bendingEnergy, energy_without_angle,
               [](const Vec9& x, double theta0, double kb) { return 0.5 * kb * square(Three(x).angle() - theta0); });

#define BENDING_FORCE_MISTAKE(id, ...)                                                                    \
  MUELLE_MISTAKE(bendingForce, id, [](const Vec9& x, [[maybe_unused]] double theta0, double kb) -> Vec9 { \
    const Three at(x);                                                                                    \
    const double angle = at.angle();                                                                      \
    [[maybe_unused]] const double torque = -kb * (angle - theta0);                                        \
    return __VA_ARGS__;                                                                                   \
  })

MUELLE_COMMON_MISTAKE(bendingForce, wrong_sign);
MUELLE_COMMON_MISTAKE(bendingForce, half_kept);
MUELLE_MISTAKE(bendingForce, doubled,
               [](const Vec9& x, double theta0, double kb) { return Vec9(2 * oracle::bendingForce(x, theta0, kb)); });
BENDING_FORCE_MISTAKE(rope, bent(at, -kb* std::max(0.0, angle - theta0), overU(at), overW(at)));
BENDING_FORCE_MISTAKE(missing_rest, bent(at, -kb* angle, overU(at), overW(at)));
BENDING_FORCE_MISTAKE(energy_for_force, bent(at, -0.5 * kb * square(angle - theta0), overU(at), overW(at)));
BENDING_FORCE_MISTAKE(length_not_squared, bent(at, torque, 1 / norm(at.u), 1 / norm(at.w)));
BENDING_FORCE_MISTAKE(not_divided_by_length, bent(at, torque, 1, 1));
BENDING_FORCE_MISTAKE(lengths_exchanged, bent(at, torque, overW(at), overU(at)));
BENDING_FORCE_MISTAKE(same_turn_on_both, bent(at, torque, overU(at), -overW(at)));
BENDING_FORCE_MISTAKE(absolute_value, bent(at, -kb* std::abs(angle - theta0), overU(at), overW(at)));
BENDING_FORCE_MISTAKE(normal_not_normalised, bent(at, torque* norm(at.normal), overU(at), overW(at)));
MUELLE_MISTAKE(bendingForce, middle_left_out, [](const Vec9& x, double theta0, double kb) {
  Vec9 F = oracle::bendingForce(x, theta0, kb);
  F.segment<3>(3).setZero();
  return F;
});
MUELLE_MISTAKE(bendingForce, last_skipped, [](const Vec9& x, double theta0, double kb) {
  Vec9 F = oracle::bendingForce(x, theta0, kb);
  F.segment<3>(6).setZero();
  return F;
});
MUELLE_MISTAKE(bendingForce, middle_reversed, [](const Vec9& x, double theta0, double kb) {
  Vec9 F = oracle::bendingForce(x, theta0, kb);
  F.segment<3>(3) *= -1;
  return F;
});

// --- area -----------------------------------------------------------------------------------------------------------

#define AREA_MISTAKE(id, ...)                                                        \
  MUELLE_MISTAKE(triangleArea, id, [](const Vec9& x) -> double {                     \
    const Three at(x);                                                               \
    return __VA_ARGS__;                                                              \
  });                                                                                \
  MUELLE_MISTAKE(areaEnergy, id, [](const Vec9& x, double A0, double kA) -> double { \
    const Three at(x);                                                               \
    return 0.5 * kA * square((__VA_ARGS__)-A0);                                      \
  });                                                                                \
  MUELLE_MISTAKE(areaForce, id, [](const Vec9& x, double A0, double kA) -> Vec9 {    \
    const Three at(x);                                                               \
    return pressed(at, -kA * ((__VA_ARGS__)-A0));                                    \
  })

AREA_MISTAKE(parallelogram, norm(at.normal));
AREA_MISTAKE(shadow, at.normal[2] / 2);
AREA_MISTAKE(squared_area, square(at.area()));
AREA_MISTAKE(half_of_square, at.normal.squaredNorm() / 2);
AREA_MISTAKE(product_of_sides, norm(at.u) * norm(at.w) / 2);
AREA_MISTAKE(dot_for_cross, std::abs(at.u.dot(at.w)) / 2);
namespace sized {
AREA_MISTAKE(shadow, std::abs(at.normal[2]) / 2);
AREA_MISTAKE(product_of_sides, norm(at.u) * norm(at.b) / 2);
}  // namespace sized

#define AREA_ENERGY_MISTAKE(id, ...)                                                                  \
  MUELLE_MISTAKE(areaEnergy, id, [](const Vec9& x, [[maybe_unused]] double A0, double kA) -> double { \
    const double area = Three(x).area();                                                              \
    return __VA_ARGS__;                                                                               \
  })

MUELLE_COMMON_MISTAKE(areaEnergy, missing_half);
AREA_ENERGY_MISTAKE(not_squared, 0.5 * kA * (area - A0));
AREA_ENERGY_MISTAKE(relative_area, 0.5 * kA * square((area - A0) / A0));
AREA_ENERGY_MISTAKE(missing_rest, 0.5 * kA * square(area));
AREA_ENERGY_MISTAKE(difference_of_squares, 0.5 * kA * (square(area) - square(A0)));

#define AREA_FORCE_MISTAKE(id, ...)                                                                \
  MUELLE_MISTAKE(areaForce, id, [](const Vec9& x, [[maybe_unused]] double A0, double kA) -> Vec9 { \
    const Three at(x);                                                                             \
    const double area = at.area();                                                                 \
    return __VA_ARGS__;                                                                            \
  })

MUELLE_COMMON_MISTAKE(areaForce, wrong_sign);
MUELLE_COMMON_MISTAKE(areaForce, half_kept);
MUELLE_MISTAKE(areaForce, doubled,
               [](const Vec9& x, double A0, double kA) { return Vec9(2 * oracle::areaForce(x, A0, kA)); });
AREA_FORCE_MISTAKE(rope, pressed(at, -kA* std::max(0.0, area - A0)));
AREA_FORCE_MISTAKE(missing_rest, pressed(at, -kA* area));
AREA_FORCE_MISTAKE(energy_for_force, pressed(at, -0.5 * kA * square(area - A0)));
AREA_FORCE_MISTAKE(absolute_value, pressed(at, -kA* std::abs(area - A0)));
AREA_FORCE_MISTAKE(normal_not_normalised, pressed(at, -2 * kA * area * (area - A0)));
AREA_FORCE_MISTAKE(along_the_normal,
                   at.isFlat() ? Vec9(Vec9::Zero())
                               : stacked(-kA*(area - A0) * at.n(), -kA*(area - A0) * at.n(), -kA*(area - A0) * at.n()));
/// As long as the pull in the plane, and across it.
namespace as_much {
AREA_FORCE_MISTAKE(along_the_normal, [&](double pull) {
  return at.isFlat() ? Vec9(Vec9::Zero())
                     : stacked(pull * (x.segment<3>(6) - x.segment<3>(3)).norm() * at.n(),
                               pull * (x.segment<3>(0) - x.segment<3>(6)).norm() * at.n(),
                               pull * (x.segment<3>(3) - x.segment<3>(0)).norm() * at.n());
}(0.5 * kA * (A0 - area)));
}
AREA_FORCE_MISTAKE(sides_not_opposite, [](const Vec9& F) {
  return stacked(F.segment<3>(3), F.segment<3>(6), F.segment<3>(0));
}(pressed(at, -kA*(area - A0))));
namespace the_other_way {
AREA_FORCE_MISTAKE(sides_not_opposite, [](const Vec9& F) {
  return stacked(F.segment<3>(6), F.segment<3>(0), F.segment<3>(3));
}(pressed(at, -kA*(area - A0))));
}  // namespace the_other_way
MUELLE_MISTAKE(areaForce, first_left_out, [](const Vec9& x, double A0, double kA) {
  Vec9 F = oracle::areaForce(x, A0, kA);
  F.head<3>().setZero();
  return F;
});
MUELLE_MISTAKE(areaForce, last_skipped, [](const Vec9& x, double A0, double kA) {
  Vec9 F = oracle::areaForce(x, A0, kA);
  F.tail<3>().setZero();
  return F;
});

// --- volume ---------------------------------------------------------------------------------------------------------

#define VOLUME_MISTAKE(id, ...)                                                         \
  MUELLE_MISTAKE(tetrahedronVolume, id, [](const Vec12& x) -> double {                  \
    const double V = Four(x).volume();                                                  \
    return __VA_ARGS__;                                                                 \
  });                                                                                   \
  MUELLE_MISTAKE(volumeEnergy, id, [](const Vec12& x, double V0, double kV) -> double { \
    const double V = Four(x).volume();                                                  \
    return 0.5 * kV * square((__VA_ARGS__)-V0);                                         \
  });                                                                                   \
  MUELLE_MISTAKE(volumeForce, id, [](const Vec12& x, double V0, double kV) -> Vec12 {   \
    const double V = Four(x).volume();                                                  \
    return pressed(Four(x), -kV * ((__VA_ARGS__)-V0));                                  \
  })

VOLUME_MISTAKE(parallelepiped, 6 * V);
VOLUME_MISTAKE(a_third, 2 * V);
VOLUME_MISTAKE(half_of_it, 3 * V);
VOLUME_MISTAKE(inverted, -V);
VOLUME_MISTAKE(never_negative, std::abs(V));

#define VOLUME_ENERGY_MISTAKE(id, ...)                                                                   \
  MUELLE_MISTAKE(volumeEnergy, id, [](const Vec12& x, [[maybe_unused]] double V0, double kV) -> double { \
    const double V = Four(x).volume();                                                                   \
    return __VA_ARGS__;                                                                                  \
  })

MUELLE_COMMON_MISTAKE(volumeEnergy, missing_half);
VOLUME_ENERGY_MISTAKE(sizes_compared, 0.5 * kV * std::pow(std::abs(V) - std::abs(V0), 2));
VOLUME_ENERGY_MISTAKE(not_squared, 0.5 * kV * (V - V0));
VOLUME_ENERGY_MISTAKE(missing_rest, 0.5 * kV * square(V));
VOLUME_ENERGY_MISTAKE(difference_of_squares, 0.5 * kV * (square(V) - square(V0)));

#define VOLUME_FORCE_MISTAKE(id, ...)                                                                  \
  MUELLE_MISTAKE(volumeForce, id, [](const Vec12& x, [[maybe_unused]] double V0, double kV) -> Vec12 { \
    const Four at(x);                                                                                  \
    const double V = at.volume();                                                                      \
    [[maybe_unused]] const double p = -kV * (V - V0) / 6;                                              \
    return __VA_ARGS__;                                                                                \
  })

/// The nodes 1, 2 and 3 get each other's faces; node 0 what is left.
#define FACES_MISTAKE(name, first, second, third)                                           \
  namespace name {                                                                          \
  MUELLE_MISTAKE(volumeForce, faces_exchanged, [](const Vec12& x, double V0, double kV) {   \
    const Vec12 F = oracle::volumeForce(x, V0, kV);                                         \
    Vec12 turned = F;                                                                       \
    turned.segment<9>(3) << F.segment<3>(first), F.segment<3>(second), F.segment<3>(third); \
    return turned;                                                                          \
  });                                                                                       \
  }
FACES_MISTAKE(of_the_node_before, 9, 3, 6)
FACES_MISTAKE(of_the_node_behind, 6, 9, 3)
FACES_MISTAKE(of_the_first_two, 6, 3, 9)
FACES_MISTAKE(of_the_last_two, 3, 9, 6)
FACES_MISTAKE(of_the_outer_two, 9, 6, 3)
MUELLE_COMMON_MISTAKE(volumeForce, wrong_sign);
MUELLE_COMMON_MISTAKE(volumeForce, half_kept);
MUELLE_MISTAKE(volumeForce, doubled,
               [](const Vec12& x, double V0, double kV) { return Vec12(2 * oracle::volumeForce(x, V0, kV)); });
VOLUME_FORCE_MISTAKE(missing_rest, pressed(at, -kV* V));
VOLUME_FORCE_MISTAKE(energy_for_force, pressed(at, -0.5 * kV * square(V - V0)));
VOLUME_FORCE_MISTAKE(absolute_value, pressed(at, -kV* std::abs(V - V0)));
VOLUME_FORCE_MISTAKE(sixth_left_out, pressed(at, -6 * kV * (V - V0)));
VOLUME_FORCE_MISTAKE(one_face_reversed, pushed(p* at.b.cross(at.c), p* at.a.cross(at.c), p* at.a.cross(at.b)));
MUELLE_MISTAKE(volumeForce, first_left_out, [](const Vec12& x, double V0, double kV) {
  Vec12 F = oracle::volumeForce(x, V0, kV);
  F.head<3>().setZero();
  return F;
});
MUELLE_MISTAKE(volumeForce, last_skipped, [](const Vec12& x, double V0, double kV) {
  Vec12 F = oracle::volumeForce(x, V0, kV);
  F.tail<3>().setZero();
  return F;
});

// --- guards and differences -----------------------------------------------------------------------------------------

namespace {

using BendingRegistration = muelle::grader::MistakeRegistration<decltype(::bendingForce)>;
using AreaRegistration = muelle::grader::MistakeRegistration<decltype(::areaForce)>;

constexpr double smallNumbers[] = {1e-2,  1e-3,  1e-4,  1e-5,  1e-6,  1e-7,  1e-8,  1e-9,  1e-10, 1e-11, 1e-12,
                                   1e-13, 1e-14, 1e-15, 1e-16, 1e-18, 1e-20, 1e-24, 1e-30, 1e-32, 1e-40, 1e-50};

struct Guards {
  std::vector<BendingRegistration> bending;
  std::vector<AreaRegistration> areas;

  /// Where the nodes pass for a line though they are none. \param size of the normal, and whether squared
  void addSmall(double small, const std::function<double(const Three&)>& size) {
    const auto isLine = [small, size](const Vec9& x) { return size(Three(x)) < small; };
    bending.emplace_back("bendingForce", "threshold", &oracle::bendingForce,
                         [isLine](const Vec9& x, double theta0, double kb) {
                           return isLine(x) ? Vec9(Vec9::Zero()) : oracle::bendingForce(x, theta0, kb);
                         });
    areas.emplace_back("areaForce", "threshold", &oracle::areaForce, [isLine](const Vec9& x, double A0, double kA) {
      return isLine(x) ? Vec9(Vec9::Zero()) : oracle::areaForce(x, A0, kA);
    });
  }

  void addUnguarded() {
    bending.emplace_back(
        "bendingForce", "unguarded", &oracle::bendingForce, [](const Vec9& x, double theta0, double kb) {
          return Three(x).isFlat() ? Vec9(Vec9::Constant(undefined)) : oracle::bendingForce(x, theta0, kb);
        });
    areas.emplace_back("areaForce", "unguarded", &oracle::areaForce, [](const Vec9& x, double A0, double kA) {
      return Three(x).isFlat() ? Vec9(Vec9::Constant(undefined)) : oracle::areaForce(x, A0, kA);
    });
  }
};

Guards registerGuards() {
  Guards guards;
  for (const double small : smallNumbers) {
    guards.addSmall(small, [](const Three& at) { return norm(at.normal); });
    guards.addSmall(small, [](const Three& at) { return norm(at.normal) / (norm(at.u) * norm(at.w)); });
  }
  guards.addUnguarded();
  return guards;
}

[[maybe_unused]] const Guards guards = registerGuards();

}  // namespace

// --- arguments in general position
// ------------------------------------------------------------------------------------

namespace {

using muelle::Random;
using muelle::threeDigits;

Vec9 someBend(Random& random) {
  return stacked(threeDigits(Vec3(random.vector3(0.3) + Vec3(-5.3, 0.7, 0.4))), threeDigits(random.vector3(0.3)),
                 threeDigits(Vec3(random.vector3(0.5) + Vec3(-2.1, 3.9, -3.2))));
}

}  // namespace

MUELLE_ARGUMENTS(bendingAngle, [](Random& random) {
  const Vec9 x = someBend(random);
  return std::tuple(x);
});
MUELLE_ARGUMENTS(bendingEnergy, [](Random& random) {
  const Vec9 x = someBend(random);
  const double theta0 = random.rounded(0.2, 0.9), kb = random.rounded(20.0, 2000.0);
  return std::tuple(x, theta0, kb);
});
MUELLE_ARGUMENTS(bendingForce, [](Random& random) {
  const Vec9 x = someBend(random);
  const double theta0 = random.rounded(0.2, 0.9), kb = random.rounded(20.0, 2000.0);
  return std::tuple(x, theta0, kb);
});
MUELLE_ARGUMENTS(triangleArea, [](Random& random) {
  const Vec9 x = someBend(random);
  return std::tuple(x);
});
MUELLE_ARGUMENTS(areaEnergy, [](Random& random) {
  const Vec9 x = someBend(random);
  const double A0 = random.rounded(0.2, 3.9), kA = random.rounded(20.0, 2000.0);
  return std::tuple(x, A0, kA);
});
MUELLE_ARGUMENTS(areaForce, [](Random& random) {
  const Vec9 x = someBend(random);
  const double A0 = random.rounded(0.2, 3.9), kA = random.rounded(20.0, 2000.0);
  return std::tuple(x, A0, kA);
});

namespace {

Vec12 someTetrahedron(Random& random) {
  Vec12 x;
  x << someBend(random), threeDigits(Vec3(random.vector3(0.5) + Vec3(0.9, 1.2, 7.3)));
  return x;
}

}  // namespace

MUELLE_ARGUMENTS(tetrahedronVolume, [](Random& random) {
  const Vec12 x = someTetrahedron(random);
  return std::tuple(x);
});
MUELLE_ARGUMENTS(volumeEnergy, [](Random& random) {
  const Vec12 x = someTetrahedron(random);
  const double V0 = random.rounded(0.2, 3.9), kV = random.rounded(20.0, 2000.0);
  return std::tuple(x, V0, kV);
});
MUELLE_ARGUMENTS(volumeForce, [](Random& random) {
  const Vec12 x = someTetrahedron(random);
  const double V0 = random.rounded(0.2, 3.9), kV = random.rounded(20.0, 2000.0);
  return std::tuple(x, V0, kV);
});
