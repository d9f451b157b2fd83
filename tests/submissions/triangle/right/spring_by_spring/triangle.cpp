#include "triangle.h"

#include <Eigen/Dense>

using namespace Eigen;

// One spring after the other, no loops.

static Vector3d pull(Vector3d from, Vector3d to, double k, double L0) {
  Vector3d d = to - from;
  return k * (d.norm() - L0) * d.normalized();  // normalized() leaves the zero vector alone
}

static double energy(Vector3d a, Vector3d b, double k, double L0) {
  double stretch = (a - b).norm() - L0;
  return k * stretch * stretch / 2;
}

Mat9 massMatrix(const Vec3& m) {
  Vec9 d;
  d << m(0), m(0), m(0), m(1), m(1), m(1), m(2), m(2), m(2);
  return d.asDiagonal();
}

double triangleEnergy(const Vec9& x, const Vec3& k, const Vec3& L0) {
  Vector3d x0 = x.head(3), x1 = x.segment(3, 3), x2 = x.tail(3);
  return energy(x0, x1, k(0), L0(0)) + energy(x1, x2, k(1), L0(1)) + energy(x2, x0, k(2), L0(2));
}

Vec9 triangleForce(const Vec9& x, const Vec3& k, const Vec3& L0) {
  Vector3d x0 = x.head(3), x1 = x.segment(3, 3), x2 = x.tail(3);
  Vector3d f01 = pull(x0, x1, k(0), L0(0));
  Vector3d f12 = pull(x1, x2, k(1), L0(1));
  Vector3d f20 = pull(x2, x0, k(2), L0(2));
  Vec9 F;
  F << f01 - f20, f12 - f01, f20 - f12;
  return F;
}
