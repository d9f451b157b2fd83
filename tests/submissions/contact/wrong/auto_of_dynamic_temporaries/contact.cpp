// loses: ColumnAtRest; misconception: none
#include "contact.h"
static muelle::VecX ones(int n) { return muelle::VecX::Ones(n); }
Vec3 planeContact(const Vec3& x, const Vec3& v, const Vec3& p, const Vec3& n, double k, double d) { const double depth = -(x-p).dot(n); if (depth <= 0) return Vec3::Zero(); return std::max(0.0, k*depth - d*v.dot(n))*n; }
Vec3 sphereContact(const Vec3& x, const Vec3& v, const Vec3& c, double R, double k, double d) { const double r = (x-c).norm(); if (r == 0) return Vec3::Zero(); const Vec3 n = (x-c)/r; return planeContact(x, v, c + R*n, n, k, d); }
std::vector<double> columnAtRest(const std::vector<double>& m, double k, double L0, double kPlane, double g) {
  const int n = m.size();
  auto rest = L0 * ones(n);                       // the temporary vector dies here
  std::vector<double> load(n + 1, 0.0);
  for (int i = n; i-- > 0;) load[i] = load[i+1] + m[i]*g;
  std::vector<double> z(n);
  z[0] = -load[0]/kPlane;
  for (int i = 1; i < n; ++i) z[i] = z[i-1] + rest[i] - load[i]/k;
  return z;
}
Vec3 frictionForce(const Vec3& v, const Vec3& n, double N, double mu, double c) { const Vec3 t = v - v.dot(n)*n; const double s = t.norm(); if (s == 0) return Vec3::Zero(); return -std::min(mu*N, c*s)*t/s; }
