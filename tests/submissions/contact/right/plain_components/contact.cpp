#include "contact.h"

Vec3 planeContact(const Vec3& x, const Vec3& v, const Vec3& p, const Vec3& n, double k, double d) {
  double depth = 0.0, vn = 0.0;
  for (int i = 0; i < 3; i++) {
    depth -= (x[i] - p[i]) * n[i];
    vn += v[i] * n[i];
  }
  double f = 0.0;
  if (depth > 0) f = k * depth - d * vn;
  if (f < 0) f = 0;
  return Vec3(f * n[0], f * n[1], f * n[2]);
}

Vec3 sphereContact(const Vec3& x, const Vec3& v, const Vec3& c, double R, double k, double d) {
  double rx = x[0] - c[0], ry = x[1] - c[1], rz = x[2] - c[2];
  double r = std::hypot(rx, ry, rz);
  if (r >= R || r == 0) return Vec3(0, 0, 0);
  double nx = rx / r, ny = ry / r, nz = rz / r;
  double vn = v[0] * nx + v[1] * ny + v[2] * nz;
  double f = k * (R - r) - d * vn;
  if (f < 0) f = 0;
  return Vec3(f * nx, f * ny, f * nz);
}

std::vector<double> columnAtRest(const std::vector<double>& m, double k, double L0, double kPlane, double g) {
  std::vector<double> z;
  for (size_t i = 0; i < m.size(); i++) {
    double above = 0;
    for (size_t j = i; j < m.size(); j++) above += m[j];
    if (i == 0)
      z.push_back(-above * g / kPlane);
    else
      z.push_back(z[i - 1] + (L0 - above * g / k));
  }
  return z;
}

Vec3 frictionForce(const Vec3& v, const Vec3& n, double N, double mu, double c) {
  double vn = v[0] * n[0] + v[1] * n[1] + v[2] * n[2];
  double tx = v[0] - vn * n[0], ty = v[1] - vn * n[1], tz = v[2] - vn * n[2];
  double t = std::hypot(tx, ty, tz);
  if (t == 0) return Vec3(0, 0, 0);
  double f = c * t;
  if (f > mu * N) f = mu * N;
  return Vec3(-f * (tx / t), -f * (ty / t), -f * (tz / t));
}
