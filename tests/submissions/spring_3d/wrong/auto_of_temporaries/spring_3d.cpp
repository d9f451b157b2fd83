// loses: HookeForce, ThirdLaw, Equivariance, ZeroLength, ShortSpring, NodeAcceleration, ElasticPendulum; misconception: none
#pragma GCC diagnostic ignored "-Wuninitialized"
#include "spring_3d.h"
double springForceMagnitude(const Vec3& xa, const Vec3& xb, double k, double L0) { return -k * ((xa - xb).norm() - L0); }
Vec3 springDirection(const Vec3& xa, const Vec3& xb) { double L = (xa-xb).norm(); if (L == 0) return Vec3::Zero(); return (xa-xb)/L; }
Vec3 springForce(const Vec3& xa, const Vec3& xb, double k, double L0) { 
  auto f = springForceMagnitude(xa,xb,k,L0)*springDirection(xa,xb); return f; }
Vec3 nodeAcceleration(const Vec3& x, double m, const std::vector<Attachment>& springs, double g) {
  Vec3 F(0,0,-m*g);
  for (auto& s : springs) F += springForce(x, s.x, s.k, s.L0);
  return F/m;
}
