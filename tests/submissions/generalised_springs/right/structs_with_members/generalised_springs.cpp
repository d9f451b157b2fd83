#include "generalised_springs.h"

#include <Eigen/Geometry>
#include <optional>

namespace {

struct Bend {
  Vec3 in, out, normal;
  explicit Bend(const Vec9& x)
      : in(x.segment<3>(3) - x.segment<3>(0)), out(x.segment<3>(6) - x.segment<3>(3)), normal(in.cross(out)) {}
  bool exists() const { return in.norm() > 0 && out.norm() > 0; }
  double angle() const { return exists() ? std::atan2(normal.norm(), in.dot(out)) : 0.0; }
  std::optional<Vec3> axis() const {
    if (normal.norm() == 0) return std::nullopt;
    return Vec3(normal / normal.norm());
  }
};

/// Half of the vector area of the triangle.
Vec3 vectorArea(const Vec9& x) {
  return 0.5 * Vec3(x.segment<3>(6) - x.segment<3>(3)).cross(Vec3(x.segment<3>(0) - x.segment<3>(3)));
}

double energyOf(double distance, double k) { return 0.5 * k * distance * distance; }

}  // namespace

double bendingAngle(const Vec9& x) { return Bend(x).angle(); }

double bendingEnergy(const Vec9& x, double theta0, double kb) {
  return Bend(x).exists() ? energyOf(bendingAngle(x) - theta0, kb) : 0.0;
}

Vec9 bendingForce(const Vec9& x, double theta0, double kb) {
  const Bend bend(x);
  const std::optional<Vec3> n = bend.axis();
  Vec9 F = Vec9::Zero();
  if (!n) return F;
  const Vec3 turnIn = n->cross(bend.in) / bend.in.squaredNorm();
  const Vec3 turnOut = n->cross(bend.out) / bend.out.squaredNorm();
  F.segment<3>(0) += turnIn;
  F.segment<3>(3) -= turnIn;
  F.segment<3>(3) -= turnOut;
  F.segment<3>(6) += turnOut;
  return F * (-kb * (bend.angle() - theta0));
}

double triangleArea(const Vec9& x) { return vectorArea(x).norm(); }

double areaEnergy(const Vec9& x, double A0, double kA) { return energyOf(triangleArea(x) - A0, kA); }

Vec9 areaForce(const Vec9& x, double A0, double kA) {
  const Vec3 area = vectorArea(x);
  Vec9 F = Vec9::Zero();
  const double A = area.norm();
  if (A == 0) return F;
  const Vec3 halfNormal = area / A / 2;
  for (int corner = 0; corner < 3; ++corner) {
    const int next = 3 * ((corner + 1) % 3), last = 3 * ((corner + 2) % 3);
    const Vec3 base = x.segment<3>(last) - x.segment<3>(next);
    F.segment<3>(3 * corner) = kA * (A0 - A) * halfNormal.cross(base);
  }
  return F;
}

double tetrahedronVolume(const Vec12& x) {
  Eigen::Matrix3d e;
  for (int i = 0; i < 3; ++i) e.col(i) = x.segment<3>(3 * i + 3) - x.segment<3>(0);
  return e.col(0).dot(e.col(1).cross(e.col(2))) / 6;
}

double volumeEnergy(const Vec12& x, double V0, double kV) { return energyOf(tetrahedronVolume(x) - V0, kV); }

Vec12 volumeForce(const Vec12& x, double V0, double kV) {
  const double push = kV * (V0 - tetrahedronVolume(x));
  Vec12 F = Vec12::Zero();
  for (int i = 1; i <= 3; ++i) {
    const int j = i % 3 + 1, l = j % 3 + 1;
    const Vec3 ej = x.segment<3>(3 * j) - x.segment<3>(0), el = x.segment<3>(3 * l) - x.segment<3>(0);
    const Vec3 f = push * ej.cross(el) / 6;
    F.segment<3>(3 * i) += f;
    F.segment<3>(0) -= f;
  }
  return F;
}
