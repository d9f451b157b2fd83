#include "generalised_springs.h"

#include <Eigen/Geometry>

using Long = Eigen::Matrix<long double, 3, 1>;
namespace {

template <class Vector>
Long side(const Vector& x, int from, int to) {
  return (x.template segment<3>(3 * to) - x.template segment<3>(3 * from)).template cast<long double>();
}
Vec3 narrowed(const Long& v) { return v.cast<double>(); }

}  // namespace

double bendingAngle(const Vec9& x) {
  const Long u = side(x, 0, 1), w = side(x, 1, 2);
  return static_cast<double>(std::atan2(u.cross(w).norm(), u.dot(w)));
}
double bendingEnergy(const Vec9& x, double theta0, double kb) {
  if (side(x, 0, 1).norm() == 0 || side(x, 1, 2).norm() == 0) return 0;
  return kb / 2 * std::pow(bendingAngle(x) - theta0, 2);
}
Vec9 bendingForce(const Vec9& x, double theta0, double kb) {
  const Long u = side(x, 0, 1), w = side(x, 1, 2), n = u.cross(w);
  if (n.norm() == 0) return Vec9::Zero();
  const long double t = -static_cast<long double>(kb) * (bendingAngle(x) - theta0) / n.norm();
  const Long a = t * n.cross(u) / u.squaredNorm(), b = t * n.cross(w) / w.squaredNorm();
  return (Vec9() << narrowed(a), narrowed(-a - b), narrowed(b)).finished();
}
double triangleArea(const Vec9& x) { return static_cast<double>(side(x, 0, 1).cross(side(x, 0, 2)).norm() / 2); }
double areaEnergy(const Vec9& x, double A0, double kA) { return kA / 2 * std::pow(triangleArea(x) - A0, 2); }
Vec9 areaForce(const Vec9& x, double A0, double kA) {
  const Long n = side(x, 0, 1).cross(side(x, 0, 2));
  if (n.norm() == 0) return Vec9::Zero();
  const long double t = -static_cast<long double>(kA) * (triangleArea(x) - A0) / (2 * n.norm());
  return (Vec9() << narrowed(t * n.cross(side(x, 1, 2))), narrowed(t * n.cross(side(x, 2, 0))),
          narrowed(t * n.cross(side(x, 0, 1))))
      .finished();
}
double tetrahedronVolume(const Vec12& x) {
  return static_cast<double>(side(x, 0, 1).dot(side(x, 0, 2).cross(side(x, 0, 3))) / 6);
}
double volumeEnergy(const Vec12& x, double V0, double kV) { return kV / 2 * std::pow(tetrahedronVolume(x) - V0, 2); }
Vec12 volumeForce(const Vec12& x, double V0, double kV) {
  const long double t = -static_cast<long double>(kV) * (tetrahedronVolume(x) - V0) / 6;
  const Long a = t * side(x, 0, 2).cross(side(x, 0, 3)), b = t * side(x, 0, 3).cross(side(x, 0, 1)),
             c = t * side(x, 0, 1).cross(side(x, 0, 2));
  return (Vec12() << narrowed(-a - b - c), narrowed(a), narrowed(b), narrowed(c)).finished();
}
