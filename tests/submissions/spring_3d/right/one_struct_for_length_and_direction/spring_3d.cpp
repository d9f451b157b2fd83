#include "spring_3d.h"

namespace {

struct Geometry {
  double length;
  Vec3 unit;
};

Geometry geometryOf(const Vec3& a, const Vec3& b) {
  Geometry result;
  const Vec3 difference = a - b;
  result.length = difference.norm();
  result.unit = Vec3::Zero();
  if (result.length > 0.0) result.unit = difference / result.length;
  return result;
}

}  // namespace

double springForceMagnitude(const Vec3& xa, const Vec3& xb, double k, double L0) {
  return -k * (geometryOf(xa, xb).length - L0);
}

Vec3 springDirection(const Vec3& xa, const Vec3& xb) { return geometryOf(xa, xb).unit; }

Vec3 springForce(const Vec3& xa, const Vec3& xb, double k, double L0) {
  const Geometry s = geometryOf(xa, xb);  // only one square root
  return -k * (s.length - L0) * s.unit;
}

Vec3 nodeAcceleration(const Vec3& x, double m, const std::vector<Attachment>& springs, double g) {
  Vec3 F(0, 0, 0);
  for (const Attachment& a : springs) {
    const Geometry s = geometryOf(x, a.x);
    F -= a.k * (s.length - a.L0) * s.unit;
  }
  F.z() -= m * g;
  return F / m;
}
