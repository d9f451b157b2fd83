#include "contact.h"

#include "grader/testing/arguments.h"
#include "grader/testing/several_mistakes.h"

using muelle::Random;
using muelle::threeDigits;
using muelle::grader::decades;
using muelle::grader::registerEach;

namespace {

/// What the two contacts compute first.
struct Geometry {
  double depth;
  Vec3 n;
  double vn;
};

Geometry ofPlane(const Vec3& x, const Vec3& v, const Vec3& p, const Vec3& n) { return {-(x - p).dot(n), n, v.dot(n)}; }

/// At the centre n is zero, and so is every force along it.
Geometry ofSphere(const Vec3& x, const Vec3& v, const Vec3& c, double R) {
  const Vec3 n = (x - c).normalized();
  return {R - (x - c).norm(), n, v.dot(n)};
}

Vec3 push(const Geometry& at, double k, double d) {
  if (at.depth <= 0.0) return Vec3::Zero();
  return std::max(0.0, k * at.depth - d * at.vn) * at.n;
}

Vec3 pushOrPull(const Geometry& at, double k, double d) {
  if (at.depth <= 0.0) return Vec3::Zero();
  return (k * at.depth - d * at.vn) * at.n;
}

/// Elastic push along n, damping of the whole velocity, zero where the leaving speed would make it pull.
Vec3 pushWithDrag(const Geometry& at, const Vec3& v, double k, double d) {
  if (at.depth <= 0.0 || k * at.depth - d * at.vn <= 0.0) return Vec3::Zero();
  return k * at.depth * at.n - d * v;
}

Vec3 sphereBeyond(double nearest, const Vec3& x, const Vec3& v, const Vec3& c, double R, double k, double d) {
  if ((x - c).norm() < nearest) return Vec3::Zero();
  return oracle::sphereContact(x, v, c, R, k, d);
}

/// A column with the given loads [N]: on the plane, and on each spring, bottom first.
std::vector<double> column(double onPlane, const std::vector<double>& onSprings, double k, double L0, double kPlane) {
  std::vector<double> z{-onPlane / kPlane};
  for (const double load : onSprings) z.push_back(z.back() + L0 - load / k);
  return z;
}

double weight(const std::vector<double>& m, std::size_t first, std::size_t last, double g) {
  double sum = 0.0;
  for (std::size_t i = first; i < last; ++i) sum += m[i] * g;
  return sum;
}

/// What each spring truly carries.
std::vector<double> loads(const std::vector<double>& m, double g) {
  std::vector<double> onSprings;
  for (std::size_t i = 1; i < m.size(); ++i) onSprings.push_back(weight(m, i, m.size(), g));
  return onSprings;
}

}  // namespace

MUELLE_COMMON_MISTAKE(planeContact, plane_wrong_sign);
MUELLE_MISTAKE(planeContact, plane_depth_sign,
               [](const Vec3& x, const Vec3& v, const Vec3& p, const Vec3& n, double k, double d) {
                 Geometry at = ofPlane(x, v, p, n);
                 at.depth = -at.depth;
                 return push(at, k, d);
               });
MUELLE_MISTAKE(planeContact, plane_everywhere,
               [](const Vec3& x, const Vec3& v, const Vec3& p, const Vec3& n, double k, double d) {
                 const Geometry at = ofPlane(x, v, p, n);
                 return Vec3((k * at.depth - d * at.vn) * n);
               });
MUELLE_MISTAKE(planeContact, plane_damps_outside,
               [](const Vec3& x, const Vec3& v, const Vec3& p, const Vec3& n, double k, double d) {
                 const Geometry at = ofPlane(x, v, p, n);
                 return Vec3(std::max(0.0, k * at.depth - d * at.vn) * n);
               });
MUELLE_MISTAKE(planeContact, plane_pulls,
               [](const Vec3& x, const Vec3& v, const Vec3& p, const Vec3& n, double k, double d) {
                 return pushOrPull(ofPlane(x, v, p, n), k, d);
               });
MUELLE_MISTAKE(planeContact, plane_clamps_damping,
               [](const Vec3& x, const Vec3& v, const Vec3& p, const Vec3& n, double k, double d) {
                 Geometry at = ofPlane(x, v, p, n);
                 at.vn = std::min(0.0, at.vn);
                 return push(at, k, d);
               });
MUELLE_MISTAKE(planeContact, plane_z_assumed,
               [](const Vec3& x, const Vec3& v, const Vec3& p, const Vec3&, double k, double d) {
                 return oracle::planeContact(x, v, p, Vec3::UnitZ(), k, d);
               });
MUELLE_MISTAKE(planeContact, plane_through_origin,
               [](const Vec3& x, const Vec3& v, const Vec3&, const Vec3& n, double k, double d) {
                 return oracle::planeContact(x, v, Vec3::Zero(), n, k, d);
               });
MUELLE_MISTAKE(planeContact, plane_damps_all,
               [](const Vec3& x, const Vec3& v, const Vec3& p, const Vec3& n, double k, double d) {
                 return pushWithDrag(ofPlane(x, v, p, n), v, k, d);
               });
MUELLE_MISTAKE(planeContact, plane_damping_sign,
               [](const Vec3& x, const Vec3& v, const Vec3& p, const Vec3& n, double k, double d) {
                 return oracle::planeContact(x, -v, p, n, k, d);
               });
MUELLE_MISTAKE(planeContact, plane_no_damping,
               [](const Vec3& x, const Vec3& v, const Vec3& p, const Vec3& n, double k, double) {
                 return oracle::planeContact(x, v, p, n, k, 0.0);
               });
MUELLE_MISTAKE(planeContact, plane_surface,
               [](const Vec3& x, const Vec3& v, const Vec3& p, const Vec3& n, double k, double d) {
                 const Geometry at = ofPlane(x, v, p, n);
                 if (at.depth < 0.0) return Vec3(Vec3::Zero());
                 return Vec3(std::max(0.0, k * at.depth - d * at.vn) * n);
               });

MUELLE_MISTAKE(sphereContact, sphere_inward,
               [](const Vec3& x, const Vec3& v, const Vec3& c, double R, double k, double d) {
                 return Vec3(-oracle::sphereContact(x, v, c, R, k, d));
               });
MUELLE_MISTAKE(sphereContact, sphere_inward_normal,
               [](const Vec3& x, const Vec3& v, const Vec3& c, double R, double k, double d) {
                 return Vec3(-oracle::sphereContact(x, -v, c, R, k, d));
               });
MUELLE_MISTAKE(sphereContact, sphere_inside_out,
               [](const Vec3& x, const Vec3& v, const Vec3& c, double R, double k, double d) {
                 Geometry at = ofSphere(x, v, c, R);
                 at.depth = -at.depth;
                 return push(at, k, d);
               });
MUELLE_MISTAKE(sphereContact, sphere_everywhere,
               [](const Vec3& x, const Vec3& v, const Vec3& c, double R, double k, double d) {
                 const Geometry at = ofSphere(x, v, c, R);
                 return Vec3((k * at.depth - d * at.vn) * at.n);
               });
MUELLE_MISTAKE(sphereContact, sphere_damps_outside,
               [](const Vec3& x, const Vec3& v, const Vec3& c, double R, double k, double d) {
                 const Geometry at = ofSphere(x, v, c, R);
                 return Vec3(std::max(0.0, k * at.depth - d * at.vn) * at.n);
               });
MUELLE_MISTAKE(sphereContact, sphere_radius_forgotten,
               [](const Vec3& x, const Vec3& v, const Vec3& c, double R, double k, double d) {
                 Geometry at = ofSphere(x, v, c, R);
                 if (at.depth > 0.0) at.depth = (x - c).norm();
                 return push(at, k, d);
               });
MUELLE_MISTAKE(sphereContact, sphere_not_normalised,
               [](const Vec3& x, const Vec3& v, const Vec3& c, double R, double k, double d) {
                 return push({R - (x - c).norm(), x - c, v.dot(x - c)}, k, d);
               });
MUELLE_MISTAKE(sphereContact, sphere_damps_all,
               [](const Vec3& x, const Vec3& v, const Vec3& c, double R, double k, double d) {
                 if (x == c) return Vec3(Vec3::Zero());
                 return pushWithDrag(ofSphere(x, v, c, R), v, k, d);
               });
MUELLE_MISTAKE(sphereContact, sphere_pulls,
               [](const Vec3& x, const Vec3& v, const Vec3& c, double R, double k, double d) {
                 return pushOrPull(ofSphere(x, v, c, R), k, d);
               });
MUELLE_MISTAKE(sphereContact, sphere_damping_sign,
               [](const Vec3& x, const Vec3& v, const Vec3& c, double R, double k, double d) {
                 return oracle::sphereContact(x, -v, c, R, k, d);
               });
MUELLE_MISTAKE(sphereContact, sphere_no_damping,
               [](const Vec3& x, const Vec3& v, const Vec3& c, double R, double k, double) {
                 return oracle::sphereContact(x, v, c, R, k, 0.0);
               });
MUELLE_MISTAKE(sphereContact, sphere_divides_by_zero,
               [](const Vec3& x, const Vec3& v, const Vec3& c, double R, double k, double d) {
                 const Vec3 n = (x - c) / (x - c).norm();
                 return push({R - (x - c).norm(), n, v.dot(n)}, k, d);
               });

MUELLE_MISTAKE(columnAtRest, column_rest_lengths,
               [](const std::vector<double>& m, double k, double L0, double kPlane, double g) {
                 return column(weight(m, 0, m.size(), g), std::vector<double>(m.size() - 1, 0.0), k, L0, kPlane);
               });
MUELLE_MISTAKE(columnAtRest, column_undeformed,
               [](const std::vector<double>& m, double k, double L0, double kPlane, double) {
                 return column(0.0, std::vector<double>(m.size() - 1, 0.0), k, L0, kPlane);
               });
MUELLE_MISTAKE(columnAtRest, column_own_weight,
               [](const std::vector<double>& m, double k, double L0, double kPlane, double g) {
                 std::vector<double> onSprings;
                 for (std::size_t i = 1; i < m.size(); ++i) onSprings.push_back(m[i] * g);
                 return column(weight(m, 0, m.size(), g), onSprings, k, L0, kPlane);
               });
MUELLE_MISTAKE(columnAtRest, column_includes_below,
               [](const std::vector<double>& m, double k, double L0, double kPlane, double g) {
                 std::vector<double> onSprings;
                 for (std::size_t i = 1; i < m.size(); ++i) onSprings.push_back(weight(m, i - 1, m.size(), g));
                 return column(weight(m, 0, m.size(), g), onSprings, k, L0, kPlane);
               });
MUELLE_MISTAKE(columnAtRest, column_upside_down,
               [](const std::vector<double>& m, double k, double L0, double kPlane, double g) {
                 std::vector<double> onSprings;
                 for (std::size_t i = 1; i < m.size(); ++i) onSprings.push_back(weight(m, 0, i, g));
                 return column(weight(m, 0, m.size(), g), onSprings, k, L0, kPlane);
               });
MUELLE_MISTAKE(columnAtRest, column_stretched,
               [](const std::vector<double>& m, double k, double L0, double kPlane, double g) {
                 return column(weight(m, 0, m.size(), g), loads(m, g), -k, L0, kPlane);
               });
MUELLE_MISTAKE(columnAtRest, column_no_depth,
               [](const std::vector<double>& m, double k, double L0, double kPlane, double g) {
                 return column(0.0, loads(m, g), k, L0, kPlane);
               });
MUELLE_MISTAKE(columnAtRest, column_depth_sign,
               [](const std::vector<double>& m, double k, double L0, double kPlane, double g) {
                 return column(-weight(m, 0, m.size(), g), loads(m, g), k, L0, kPlane);
               });
MUELLE_MISTAKE(columnAtRest, column_bottom_alone,
               [](const std::vector<double>& m, double k, double L0, double kPlane, double g) {
                 return column(m[0] * g, loads(m, g), k, L0, kPlane);
               });

MUELLE_COMMON_MISTAKE(frictionForce, friction_wrong_sign);
MUELLE_MISTAKE(frictionForce, friction_total_velocity, [](const Vec3& v, const Vec3&, double N, double mu, double c) {
  return v.norm() > 0.0 ? Vec3(-std::min(mu * N, c * v.norm()) * v.normalized()) : Vec3(Vec3::Zero());
});
MUELLE_MISTAKE(frictionForce, friction_no_cap,
               [](const Vec3& v, const Vec3& n, double, double, double c) { return Vec3(-c * (v - v.dot(n) * n)); });
MUELLE_MISTAKE(frictionForce, friction_no_ramp, [](const Vec3& v, const Vec3& n, double N, double mu, double) {
  const Vec3 tangential = v - v.dot(n) * n;
  return tangential.norm() > 0.0 ? Vec3(-mu * N * tangential.normalized()) : Vec3(Vec3::Zero());
});
MUELLE_MISTAKE(frictionForce, friction_max, [](const Vec3& v, const Vec3& n, double N, double mu, double c) {
  const Vec3 tangential = v - v.dot(n) * n;
  const double size = std::max(mu * N, c * tangential.norm());
  return tangential.norm() > 0.0 ? Vec3(-size * tangential.normalized()) : Vec3(Vec3::Zero());
});
MUELLE_MISTAKE(frictionForce, friction_no_normal_force, [](const Vec3& v, const Vec3& n, double, double mu, double c) {
  return oracle::frictionForce(v, n, 1.0, mu, c);
});
MUELLE_MISTAKE(frictionForce, friction_divides_by_zero,
               [](const Vec3& v, const Vec3& n, double N, double mu, double c) {
                 const Vec3 tangential = v - v.dot(n) * n;
                 return Vec3(-std::min(mu * N, c * tangential.norm()) * tangential / tangential.norm());
               });

MUELLE_MISTAKE(planeContact, energy_for_force,
               [](const Vec3& x, const Vec3& v, const Vec3& p, const Vec3& n, double k, double d) {
                 Geometry at = ofPlane(x, v, p, n);
                 at.depth *= std::abs(at.depth) / 2.0;
                 return push(at, k, d);
               });
MUELLE_MISTAKE(planeContact, plane_depth_squared,
               [](const Vec3& x, const Vec3& v, const Vec3& p, const Vec3& n, double k, double d) {
                 Geometry at = ofPlane(x, v, p, n);
                 at.depth *= std::abs(at.depth);
                 return push(at, k, d);
               });
MUELLE_MISTAKE(planeContact, plane_both_sides,
               [](const Vec3& x, const Vec3& v, const Vec3& p, const Vec3& n, double k, double d) {
                 Geometry at = ofPlane(x, v, p, n);
                 at.depth = std::abs(at.depth);
                 return push(at, k, d);
               });
MUELLE_MISTAKE(planeContact, plane_absolute_speed,
               [](const Vec3& x, const Vec3& v, const Vec3& p, const Vec3& n, double k, double d) {
                 Geometry at = ofPlane(x, v, p, n);
                 at.vn = -std::abs(at.vn);
                 return push(at, k, d);
               });
MUELLE_MISTAKE(planeContact, plane_lets_go,
               [](const Vec3& x, const Vec3& v, const Vec3& p, const Vec3& n, double k, double d) {
                 const Geometry at = ofPlane(x, v, p, n);
                 return at.vn > 0.0 ? Vec3(Vec3::Zero()) : push(at, k, d);
               });
MUELLE_MISTAKE(planeContact, plane_depth_along_z,
               [](const Vec3& x, const Vec3& v, const Vec3& p, const Vec3& n, double k, double d) {
                 Geometry at = ofPlane(x, v, p, n);
                 at.depth = p.z() - x.z();
                 return push(at, k, d);
               });
MUELLE_MISTAKE(planeContact, plane_positive_part,
               [](const Vec3& x, const Vec3& v, const Vec3& p, const Vec3& n, double k, double d) {
                 return Vec3(pushOrPull(ofPlane(x, v, p, n), k, d).cwiseMax(0.0));
               });
[[maybe_unused]] static const bool planeComponents =
    registerEach("planeContact", "plane_component_missing", &oracle::planeContact, {0, 1, 2}, [](double component) {
      return [i = static_cast<int>(component)](const Vec3& x, const Vec3& v, const Vec3& p, const Vec3& n, double k,
                                               double d) {
        Geometry at = ofPlane(x, v, p, n);
        at.depth += (x[i] - p[i]) * n[i];
        return push(at, k, d);
      };
    });
[[maybe_unused]] static const bool planeThresholds =
    registerEach("planeContact", "plane_threshold", &oracle::planeContact, decades(-1, -29), [](double least) {
      return [least](const Vec3& x, const Vec3& v, const Vec3& p, const Vec3& n, double k, double d) {
        const Geometry at = ofPlane(x, v, p, n);
        return at.depth < least ? Vec3(Vec3::Zero()) : push(at, k, d);
      };
    });
/// The spring of a plane that is cut at the surface, and its damper that is not.
[[maybe_unused]] static const bool planeDamperEverywhere =
    registerEach("planeContact", "plane_damps_outside", &oracle::planeContact, {0}, [](double) {
      return [](const Vec3& x, const Vec3& v, const Vec3& p, const Vec3& n, double k, double d) {
        const Geometry at = ofPlane(x, v, p, n);
        return Vec3((k * std::max(0.0, at.depth) - d * at.vn) * at.n);
      };
    });
[[maybe_unused]] static const bool planeDamperNearby =
    registerEach("planeContact", "plane_damps_outside", &oracle::planeContact, decades(-1, -15), [](double reach) {
      return [reach](const Vec3& x, const Vec3& v, const Vec3& p, const Vec3& n, double k, double d) {
        const Geometry at = ofPlane(x, v, p, n);
        return at.depth < -reach ? Vec3(Vec3::Zero()) : Vec3(std::max(0.0, k * at.depth - d * at.vn) * at.n);
      };
    });

MUELLE_MISTAKE(sphereContact, sphere_surface,
               [](const Vec3& x, const Vec3& v, const Vec3& c, double R, double k, double d) {
                 const Geometry at = ofSphere(x, v, c, R);
                 return at.depth < 0.0 ? Vec3(Vec3::Zero()) : Vec3(std::max(0.0, k * at.depth - d * at.vn) * at.n);
               });
MUELLE_MISTAKE(sphereContact, sphere_difference_of_squares,
               [](const Vec3& x, const Vec3& v, const Vec3& c, double R, double k, double d) {
                 Geometry at = ofSphere(x, v, c, R);
                 at.depth = R * R - (x - c).squaredNorm();
                 return push(at, k, d);
               });
MUELLE_MISTAKE(sphereContact, sphere_divided_by_radius,
               [](const Vec3& x, const Vec3& v, const Vec3& c, double R, double k, double d) {
                 return push({R - (x - c).norm(), (x - c) / R, v.dot(x - c) / R}, k, d);
               });
[[maybe_unused]] static const bool sphereComponents =
    registerEach("sphereContact", "sphere_component_missing", &oracle::sphereContact, {0, 1, 2}, [](double component) {
      return
          [i = static_cast<int>(component)](const Vec3& x, const Vec3& v, const Vec3& c, double R, double k, double d) {
            Vec3 seen = x;
            seen[i] = c[i];
            return oracle::sphereContact(seen, v, c, R, k, d);
          };
    });
[[maybe_unused]] static const bool sphereShallow =
    registerEach("sphereContact", "sphere_shallow", &oracle::sphereContact, decades(-1, -13), [](double least) {
      return [least](const Vec3& x, const Vec3& v, const Vec3& c, double R, double k, double d) {
        return R - (x - c).norm() < least ? Vec3(Vec3::Zero()) : oracle::sphereContact(x, v, c, R, k, d);
      };
    });
[[maybe_unused]] static const bool sphereThresholds =
    registerEach("sphereContact", "sphere_threshold", &oracle::sphereContact, decades(-1, -9), [](double nearest) {
      return [nearest](const Vec3& x, const Vec3& v, const Vec3& c, double R, double k, double d) {
        return sphereBeyond(nearest, x, v, c, R, k, d);
      };
    });
[[maybe_unused]] static const bool sphereSmallThresholds = registerEach(
    "sphereContact", "sphere_small_threshold", &oracle::sphereContact, decades(-10, -99), [](double nearest) {
      return [nearest](const Vec3& x, const Vec3& v, const Vec3& c, double R, double k, double d) {
        return sphereBeyond(nearest, x, v, c, R, k, d);
      };
    });
[[maybe_unused]] static const bool sphereApproximately = registerEach(
    "sphereContact", "sphere_small_threshold", &oracle::sphereContact, {1e-12, 1e-9}, [](double precision) {
      return [precision](const Vec3& x, const Vec3& v, const Vec3& c, double R, double k, double d) {
        return x.isApprox(c, precision) ? Vec3(Vec3::Zero()) : oracle::sphereContact(x, v, c, R, k, d);
      };
    });
[[maybe_unused]] static const bool sphereSoftened =
    registerEach("sphereContact", "softened_length", &oracle::sphereContact, decades(-3, -20), [](double added) {
      return [added](const Vec3& x, const Vec3& v, const Vec3& c, double R, double k, double d) {
        const double distance = (x - c).norm();
        const Vec3 n = (x - c) / (distance + added);
        return push({R - distance, n, v.dot(n)}, k, d);
      };
    });
[[maybe_unused]] static const bool sphereSoftenedSquare =
    registerEach("sphereContact", "softened_length", &oracle::sphereContact, decades(-6, -30), [](double added) {
      return [added](const Vec3& x, const Vec3& v, const Vec3& c, double R, double k, double d) {
        const double distance = (x - c).norm();
        const Vec3 n = (x - c) / std::sqrt(distance * distance + added);
        return push({R - distance, n, v.dot(n)}, k, d);
      };
    });

MUELLE_MISTAKE(columnAtRest, column_single_on_surface,
               [](const std::vector<double>& m, double k, double L0, double kPlane, double g) {
                 return m.size() == 1 ? std::vector<double>{0.0} : oracle::columnAtRest(m, k, L0, kPlane, g);
               });
MUELLE_MISTAKE(columnAtRest, column_top_forgotten,
               [](const std::vector<double>& m, double k, double L0, double kPlane, double g) {
                 std::vector<double> others = m;
                 others.back() = 0.0;
                 return oracle::columnAtRest(others, k, L0, kPlane, g);
               });

MUELLE_MISTAKE(frictionForce, friction_horizontal, [](const Vec3& v, const Vec3&, double N, double mu, double c) {
  return oracle::frictionForce(v, Vec3::UnitZ(), N, mu, c);
});
MUELLE_MISTAKE(frictionForce, friction_by_components, [](const Vec3& v, const Vec3& n, double N, double mu, double c) {
  const Vec3 ramp = -c * (v - v.dot(n) * n);
  return Vec3(ramp.cwiseMin(mu * N).cwiseMax(-mu * N));
});
MUELLE_MISTAKE(frictionForce, friction_not_normalised, [](const Vec3& v, const Vec3& n, double N, double mu, double c) {
  const Vec3 tangential = v - v.dot(n) * n;
  return Vec3(-std::min(mu * N, c * tangential.norm()) * tangential);
});
[[maybe_unused]] static const bool frictionThresholds =
    registerEach("frictionForce", "friction_threshold", &oracle::frictionForce, decades(-1, -99), [](double slowest) {
      return [slowest](const Vec3& v, const Vec3& n, double N, double mu, double c) {
        const bool isSlow = (v - v.dot(n) * n).norm() < slowest;
        return isSlow ? Vec3(Vec3::Zero()) : oracle::frictionForce(v, n, N, mu, c);
      };
    });

// Nodes inside on their way in, where the damper counts too; so deep and fast that something is left of a number that
// is cut to a whole one. Below the plane along each axis, so that a part of the sum (x - p) . n tells the same.
MUELLE_ARGUMENTS(planeContact, [](Random& random) {
  Vec3 n = random.roundedDirection();
  n.z() = std::abs(n.z());
  const Vec3 p = threeDigits(random.vector3(3.0));
  Vec3 x, v;
  for (int i = 0; i < 3; ++i) {
    x[i] = threeDigits(p[i] - random.number(4.0, 40.0) * n[i]);
    v[i] = threeDigits(-random.number(3.0, 90.0) * n[i]);
  }
  const double k = random.rounded(200.0, 2000.0), d = random.rounded(3.0, 30.0);
  return std::tuple(x, v, p, n, k, d);
});
MUELLE_ARGUMENTS(sphereContact, [](Random& random) {
  const Vec3 n = random.roundedDirection(), c = threeDigits(random.vector3(3.0));
  const double R = random.rounded(60.0, 300.0);
  const Vec3 x = threeDigits(Vec3(c + (R - random.number(4.0, 40.0)) * n));
  const Vec3 v = threeDigits(Vec3(-random.number(3.0, 90.0) * n));
  const double k = random.rounded(200.0, 2000.0), d = random.rounded(3.0, 30.0);
  return std::tuple(x, v, c, R, k, d);
});
