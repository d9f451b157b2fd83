#include "damping.h"

#include "grader/testing/arguments.h"
#include "grader/testing/several_mistakes.h"

#include <Eigen/Geometry>

using muelle::Random;
using muelle::threeDigits;
using muelle::grader::decades;
using muelle::grader::registerEach;

namespace {

/// Projected damping, but zero below the given length.
Vec3 zeroBelow(double shortest, const Vec3& xa, const Vec3& xb, const Vec3& va, const Vec3& vb, double d) {
  if ((xa - xb).norm() < shortest) return Vec3::Zero();
  return oracle::projectedDamping(xa, xb, va, vb, d);
}

/// Projected damping by a damped rate and a direction.
Vec3 alongSpring(double rate, const Vec3& xa, const Vec3& xb, double d) {
  return -d * rate * (xa - xb).stableNormalized();
}

double rateOf(const Vec3& xa, const Vec3& xb, const Vec3& va, const Vec3& vb) {
  return (va - vb).dot((xa - xb).stableNormalized());
}

}  // namespace

MUELLE_COMMON_MISTAKE(nodeDamping, node_wrong_sign);
MUELLE_MISTAKE(nodeDamping, node_d_missing, [](const Vec3& va, double) { return Vec3(-va); });
MUELLE_MISTAKE(nodeDamping, node_quadratic, [](const Vec3& va, double d) { return Vec3(-d * va.norm() * va); });
MUELLE_MISTAKE(nodeDamping, node_constant_size, [](const Vec3& va, double d) { return Vec3(-d * va.normalized()); });

MUELLE_MISTAKE(nodeDamping, node_divided,
               [](const Vec3& va, double d) { return d == 0.0 ? Vec3(Vec3::Zero()) : Vec3(-va / d); });
MUELLE_MISTAKE(nodeDamping, node_vertical, [](const Vec3& va, double d) { return Vec3(0, 0, -d * va.z()); });

MUELLE_COMMON_MISTAKE(relativeDamping, relative_wrong_sign);
MUELLE_MISTAKE(relativeDamping, relative_d_missing,
               [](const Vec3& va, const Vec3& vb, double) { return Vec3(vb - va); });
MUELLE_MISTAKE(relativeDamping, relative_ignores_b,
               [](const Vec3& va, const Vec3&, double d) { return Vec3(-d * va); });
MUELLE_MISTAKE(relativeDamping, relative_adds,
               [](const Vec3& va, const Vec3& vb, double d) { return Vec3(-d * (va + vb)); });
MUELLE_COMMON_MISTAKE(relativeDamping, relative_half);

MUELLE_COMMON_MISTAKE(projectedDamping, projected_wrong_sign);
MUELLE_MISTAKE(projectedDamping, projected_d_missing,
               [](const Vec3& xa, const Vec3& xb, const Vec3& va, const Vec3& vb, double) {
                 return oracle::projectedDamping(xa, xb, va, vb, 1.0);
               });
MUELLE_MISTAKE(projectedDamping, projected_ignores_b,
               [](const Vec3& xa, const Vec3& xb, const Vec3& va, const Vec3&, double d) {
                 return oracle::projectedDamping(xa, xb, va, Vec3::Zero(), d);
               });
MUELLE_MISTAKE(projectedDamping, projected_adds,
               [](const Vec3& xa, const Vec3& xb, const Vec3& va, const Vec3& vb, double d) {
                 return oracle::projectedDamping(xa, xb, va, -vb, d);
               });
// A student who does not project has no reason to look at L; one who does may still return zero where L = 0.
MUELLE_MISTAKE(projectedDamping, not_projected, [](const Vec3&, const Vec3&, const Vec3& va, const Vec3& vb, double d) {
  return oracle::relativeDamping(va, vb, d);
});
MUELLE_MISTAKE(projectedDamping, not_projected_from_zero,
               [](const Vec3& xa, const Vec3& xb, const Vec3& va, const Vec3& vb, double d) {
                 return xa == xb ? Vec3(Vec3::Zero()) : oracle::relativeDamping(va, vb, d);
               });
MUELLE_MISTAKE(projectedDamping, rejected,
               [](const Vec3& xa, const Vec3& xb, const Vec3& va, const Vec3& vb, double d) {
                 if (xa == xb) return Vec3(Vec3::Zero());
                 return Vec3(oracle::relativeDamping(va, vb, d) - oracle::projectedDamping(xa, xb, va, vb, d));
               });
MUELLE_MISTAKE(projectedDamping, not_normalised,
               [](const Vec3& xa, const Vec3& xb, const Vec3& va, const Vec3& vb, double d) {
                 return Vec3(-d * (va - vb).dot(xa - xb) * (xa - xb));
               });
MUELLE_MISTAKE(projectedDamping, normalised_once,
               [](const Vec3& xa, const Vec3& xb, const Vec3& va, const Vec3& vb, double d) {
                 return Vec3((xa - xb).norm() * oracle::projectedDamping(xa, xb, va, vb, d));
               });
MUELLE_MISTAKE(projectedDamping, scalar_speed,
               [](const Vec3& xa, const Vec3& xb, const Vec3& va, const Vec3& vb, double d) {
                 return Vec3(-d * (va - vb).norm() * (xa - xb).normalized());
               });
MUELLE_MISTAKE(projectedDamping, absolute_speed,
               [](const Vec3& xa, const Vec3& xb, const Vec3& va, const Vec3& vb, double d) {
                 const Vec3 u = (xa - xb).normalized();
                 return Vec3(-d * std::abs((va - vb).dot(u)) * u);
               });
MUELLE_MISTAKE(projectedDamping, divides_by_zero,
               [](const Vec3& xa, const Vec3& xb, const Vec3& va, const Vec3& vb, double d) {
                 const Vec3 u = (xa - xb) / (xa - xb).norm();
                 return Vec3(-d * (va - vb).dot(u) * u);
               });

MUELLE_MISTAKE(nodeDamping, energy_for_force, [](const Vec3& va, double d) { return Vec3(-d / 2.0 * va.norm() * va); });
[[maybe_unused]] static const bool nodeThresholds =
    registerEach("nodeDamping", "node_threshold", &oracle::nodeDamping, decades(-1, -99), [](double slowest) {
      return [slowest](const Vec3& va, double d) {
        return va.norm() < slowest ? Vec3(Vec3::Zero()) : oracle::nodeDamping(va, d);
      };
    });

MUELLE_MISTAKE(relativeDamping, relative_quadratic,
               [](const Vec3& va, const Vec3& vb, double d) { return Vec3(-d * (va - vb).norm() * (va - vb)); });
MUELLE_MISTAKE(relativeDamping, relative_constant_size,
               [](const Vec3& va, const Vec3& vb, double d) { return Vec3(-d * (va - vb).stableNormalized()); });
MUELLE_MISTAKE(relativeDamping, relative_faster_only, [](const Vec3& va, const Vec3& vb, double d) {
  return va.norm() < vb.norm() ? Vec3(Vec3::Zero()) : oracle::relativeDamping(va, vb, d);
});
MUELLE_MISTAKE(relativeDamping, relative_speeds, [](const Vec3& va, const Vec3& vb, double d) {
  return va.norm() == 0.0 ? Vec3(d * vb) : Vec3(-d * (va.norm() - vb.norm()) * va.stableNormalized());
});

MUELLE_MISTAKE(projectedDamping, projected_axis_from_a,
               [](const Vec3& xa, const Vec3&, const Vec3& va, const Vec3& vb, double d) {
                 return alongSpring(rateOf(xa, Vec3::Zero(), va, vb), xa, Vec3::Zero(), d);
               });
MUELLE_MISTAKE(projectedDamping, projected_damped_twice,
               [](const Vec3& xa, const Vec3& xb, const Vec3& va, const Vec3& vb, double d) {
                 return alongSpring(-d * rateOf(xa, xb, va, vb), xa, xb, d);
               });
MUELLE_MISTAKE(projectedDamping, projected_stretching_only,
               [](const Vec3& xa, const Vec3& xb, const Vec3& va, const Vec3& vb, double d) {
                 return alongSpring(std::max(0.0, rateOf(xa, xb, va, vb)), xa, xb, d);
               });
MUELLE_MISTAKE(projectedDamping, projected_by_components,
               [](const Vec3& xa, const Vec3& xb, const Vec3& va, const Vec3& vb, double d) {
                 const Vec3 u = (xa - xb).stableNormalized();
                 return Vec3(-d * (va - vb).cwiseProduct(u).cwiseProduct(u));
               });
MUELLE_MISTAKE(projectedDamping, projected_divided_thrice,
               [](const Vec3& xa, const Vec3& xb, const Vec3& va, const Vec3& vb, double d) {
                 const double L = (xa - xb).norm();
                 return L > 0.0 ? Vec3(oracle::projectedDamping(xa, xb, va, vb, d) / L) : Vec3(Vec3::Zero());
               });
MUELLE_MISTAKE(projectedDamping, projected_exchanged,
               [](const Vec3& xa, const Vec3& xb, const Vec3& va, const Vec3& vb, double d) {
                 return oracle::projectedDamping(va, vb, xa, xb, d);
               });
MUELLE_MISTAKE(projectedDamping, projected_whole_rate,
               [](const Vec3& xa, const Vec3& xb, const Vec3& va, const Vec3& vb, double d) {
                 return alongSpring(std::trunc(rateOf(xa, xb, va, vb)), xa, xb, d);
               });
MUELLE_MISTAKE(projectedDamping, projected_vertical,
               [](const Vec3& xa, const Vec3& xb, const Vec3& va, const Vec3& vb, double d) {
                 return xa == xb ? Vec3(Vec3::Zero()) : Vec3(0, 0, -d * (va.z() - vb.z()));
               });
MUELLE_MISTAKE(projectedDamping, projected_at_zero_length,
               [](const Vec3& xa, const Vec3& xb, const Vec3& va, const Vec3& vb, double d) {
                 return xa == xb ? oracle::relativeDamping(va, vb, d) : oracle::projectedDamping(xa, xb, va, vb, d);
               });
[[maybe_unused]] static const bool projectedComponents = registerEach(
    "projectedDamping", "projected_component_missing", &oracle::projectedDamping, {0, 1, 2}, [](double component) {
      return
          [i = static_cast<int>(component)](const Vec3& xa, const Vec3& xb, const Vec3& va, const Vec3& vb, double d) {
            Vec3 seen = va;
            seen[i] = vb[i];
            return oracle::projectedDamping(xa, xb, seen, vb, d);
          };
    });
[[maybe_unused]] static const bool projectedThresholds =
    registerEach("projectedDamping", "threshold", &oracle::projectedDamping, decades(-1, -9), [](double shortest) {
      return [shortest](const Vec3& xa, const Vec3& xb, const Vec3& va, const Vec3& vb, double d) {
        return zeroBelow(shortest, xa, xb, va, vb, d);
      };
    });
[[maybe_unused]] static const bool projectedSmallThresholds = registerEach(
    "projectedDamping", "small_threshold", &oracle::projectedDamping, decades(-10, -99), [](double shortest) {
      return [shortest](const Vec3& xa, const Vec3& xb, const Vec3& va, const Vec3& vb, double d) {
        return zeroBelow(shortest, xa, xb, va, vb, d);
      };
    });
[[maybe_unused]] static const bool projectedApproximately =
    registerEach("projectedDamping", "threshold", &oracle::projectedDamping, {1e-6, 1e-9, 1e-12}, [](double precision) {
      return [precision](const Vec3& xa, const Vec3& xb, const Vec3& va, const Vec3& vb, double d) {
        return xa.isApprox(xb, precision) ? Vec3(Vec3::Zero()) : oracle::projectedDamping(xa, xb, va, vb, d);
      };
    });
[[maybe_unused]] static const bool projectedSoftened =
    registerEach("projectedDamping", "softened_length", &oracle::projectedDamping, decades(-3, -20), [](double added) {
      return [added](const Vec3& xa, const Vec3& xb, const Vec3& va, const Vec3& vb, double d) {
        const Vec3 u = (xa - xb) / ((xa - xb).norm() + added);
        return Vec3(-d * (va - vb).dot(u) * u);
      };
    });
[[maybe_unused]] static const bool projectedSoftenedSquare =
    registerEach("projectedDamping", "softened_length", &oracle::projectedDamping, decades(-6, -40), [](double added) {
      return [added](const Vec3& xa, const Vec3& xb, const Vec3& va, const Vec3& vb, double d) {
        const Vec3 r = xa - xb;
        return Vec3(-d * (va - vb).dot(r) / (r.squaredNorm() + added) * r);
      };
    });

MUELLE_ARGUMENTS(nodeDamping, [](Random& random) {
  const Vec3 va = threeDigits(Vec3(random.number(1.0, 5.0) * random.roundedDirection()));
  const double d = threeDigits(random.positive(0.2, 20.0));
  return std::tuple(va, d);
});

// Springs that grow longer, with a the faster end; speeds of which hardly two have the same whole part.
MUELLE_ARGUMENTS(relativeDamping, [](Random& random) {
  const Vec3 va = threeDigits(Vec3(random.number(100.0, 5000.0) * random.roundedDirection()));
  const Vec3 vb = threeDigits(Vec3(random.number(5.0, 90.0) * random.roundedDirection()));
  const double d = threeDigits(random.positive(0.2, 20.0));
  return std::tuple(va, vb, d);
});
MUELLE_ARGUMENTS(projectedDamping, [](Random& random) {
  const Vec3 n = random.roundedDirection(), xb = threeDigits(random.vector3(2.0));
  const Vec3 xa = threeDigits(Vec3(xb + random.number(0.5, 3.0) * n));
  const Vec3 va = threeDigits(Vec3(random.number(100.0, 5000.0) * n + n.cross(random.vector3(1.0))));
  const Vec3 vb = threeDigits(Vec3(random.number(5.0, 90.0) * n + n.cross(random.vector3(1.0))));
  const double d = threeDigits(random.positive(0.2, 20.0));
  return std::tuple(xa, xb, va, vb, d);
});
