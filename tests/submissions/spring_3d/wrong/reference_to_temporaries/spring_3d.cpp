// loses: ZeroLength, ShortSpring, NodeAcceleration, ElasticPendulum; misconception: none
#include "spring_3d.h"
double springForceMagnitude(const Vec3& xa, const Vec3& xb, double k, double L0) { return -k * ((xa - xb).norm() - L0); }
const Vec3& longer(const Vec3& a, const Vec3& b) { return a.squaredNorm() > b.squaredNorm() ? a : b; }
Vec3 springDirection(const Vec3& xa, const Vec3& xb) { double L = (xa-xb).norm(); if (L == 0) return Vec3::Zero(); return (xa-xb)/L; }
Vec3 springForce(const Vec3& xa, const Vec3& xb, double k, double L0) { return springForceMagnitude(xa,xb,k,L0)*springDirection(xa,xb); }
Vec3 nodeAcceleration(const Vec3& x, double m, const std::vector<Attachment>& springs, double g) {
  const Vec3& w = longer(Vec3(0,0,-m*g), Vec3::Zero());
  Vec3 F = Vec3::Zero();
  for (auto& s : springs) F += springForce(x, s.x, s.k, s.L0);
  F += w;
  return F/m;
}
