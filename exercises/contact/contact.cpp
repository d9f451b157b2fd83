#include "contact.h"

Vec3 planeContact(const Vec3& x, const Vec3& v, const Vec3& p, const Vec3& n, double k, double d) {
  (void)x;
  (void)v;
  (void)p;
  (void)n;
  (void)k;
  (void)d;
  return Vec3::Zero();
}

Vec3 sphereContact(const Vec3& x, const Vec3& v, const Vec3& c, double R, double k, double d) {
  (void)x;
  (void)v;
  (void)c;
  (void)R;
  (void)k;
  (void)d;
  return Vec3::Zero();
}

std::vector<double> columnAtRest(const std::vector<double>& m, double k, double L0, double kPlane, double g) {
  (void)k;
  (void)L0;
  (void)kPlane;
  (void)g;
  return std::vector<double>(m.size(), 0.0);
}

// Optional.
Vec3 frictionForce(const Vec3& v, const Vec3& n, double N, double mu, double c) {
  (void)v;
  (void)n;
  (void)N;
  (void)mu;
  (void)c;
  return Vec3::Zero();
}
