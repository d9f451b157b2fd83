#include "damping.h"

#include "grader/testing/mistakes.h"

namespace {

/// Projected damping, but zero below the given length.
Vec3 zeroBelow(double shortest, const Vec3& xa, const Vec3& xb, const Vec3& va, const Vec3& vb, double d) {
  if ((xa - xb).norm() < shortest) return Vec3::Zero();
  return oracle::projectedDamping(xa, xb, va, vb, d);
}

}  // namespace

MUELLE_COMMON_MISTAKE(nodeDamping, node_wrong_sign);
MUELLE_MISTAKE(nodeDamping, node_d_missing, [](const Vec3& va, double) { return Vec3(-va); });
MUELLE_MISTAKE(nodeDamping, node_quadratic, [](const Vec3& va, double d) { return Vec3(-d * va.norm() * va); });
MUELLE_MISTAKE(nodeDamping, node_constant_size, [](const Vec3& va, double d) { return Vec3(-d * va.normalized()); });

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
MUELLE_MISTAKE(projectedDamping, threshold,
               [](const Vec3& xa, const Vec3& xb, const Vec3& va, const Vec3& vb, double d) {
                 return zeroBelow(1e-8, xa, xb, va, vb, d);
               });
MUELLE_MISTAKE(projectedDamping, small_threshold,
               [](const Vec3& xa, const Vec3& xb, const Vec3& va, const Vec3& vb, double d) {
                 return zeroBelow(1e-11, xa, xb, va, vb, d);
               });
MUELLE_MISTAKE(projectedDamping, divides_by_zero,
               [](const Vec3& xa, const Vec3& xb, const Vec3& va, const Vec3& vb, double d) {
                 const Vec3 u = (xa - xb) / (xa - xb).norm();
                 return Vec3(-d * (va - vb).dot(u) * u);
               });
