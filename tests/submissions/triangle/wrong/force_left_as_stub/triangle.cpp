// loses: TriangleForce, MinusTheGradient, NewtonsThirdLaw, Equivariance, CoincidentNodes, TinyLengths, FreeFlight; misconception: zero
// the forces were computed and not returned
#include "triangle.h"

Mat9 massMatrix(const Vec3& m) {
  Vec9 diag;
  diag << m[0], m[0], m[0], m[1], m[1], m[1], m[2], m[2], m[2];
  return diag.asDiagonal();
}

double triangleEnergy(const Vec9& x, const Vec3& k, const Vec3& L0) {
  Vec3 x0 = x.head<3>();
  Vec3 x1 = x.segment<3>(3);
  Vec3 x2 = x.tail<3>();

  double s01 = (x0 - x1).norm() - L0[0];
  double s12 = (x1 - x2).norm() - L0[1];
  double s20 = (x2 - x0).norm() - L0[2];

  double E01 = 0.5 * k[0] * s01 * s01;
  double E12 = 0.5 * k[1] * s12 * s12;
  double E20 = 0.5 * k[2] * s20 * s20;
  return E01 + E12 + E20;
}

Vec9 triangleForce(const Vec9& x, const Vec3& k, const Vec3& L0) {
  Vec3 x0 = x.head<3>();
  Vec3 x1 = x.segment<3>(3);
  Vec3 x2 = x.tail<3>();

  double L01 = (x0 - x1).norm();
  double L12 = (x1 - x2).norm();
  double L20 = (x2 - x0).norm();

  // f01 is the force of spring 01 on node 0
  Vec3 f01 = Vec3::Zero();
  if (L01 > 0) f01 = -k[0] * (L01 - L0[0]) * (x0 - x1) / L01;
  Vec3 f12 = Vec3::Zero();
  if (L12 > 0) f12 = -k[1] * (L12 - L0[1]) * (x1 - x2) / L12;
  Vec3 f20 = Vec3::Zero();
  if (L20 > 0) f20 = -k[2] * (L20 - L0[2]) * (x2 - x0) / L20;

  Vec9 F;
  F << f01 - f20, f12 - f01, f20 - f12;
  return Vec9::Zero();
}
