#include "contact.h"

Vec3 planeContact(const Vec3& x, const Vec3& v, const Vec3& p, const Vec3& n, double k, double d) {
  double depth = 0, leaving = 0;
  for (int i = 0; i < 3; i++) {
    depth -= (x[i] - p[i]) * n[i];
    leaving += v[i] * n[i];
  }
  if (!(depth > 0)) return Vec3(0, 0, 0);
  double f = k * depth - d * leaving;
  if (f < 0) return Vec3(0, 0, 0);
  return Vec3(f * n[0], f * n[1], f * n[2]);
}

Vec3 sphereContact(const Vec3& x, const Vec3& v, const Vec3& c, double R, double k, double d) {
  double dx = x[0] - c[0], dy = x[1] - c[1], dz = x[2] - c[2];
  double r = std::hypot(dx, dy, dz);
  if (r == 0 || r >= R) return Vec3(0, 0, 0);
  double nx = dx / r, ny = dy / r, nz = dz / r;
  double f = k * (R - r) - d * (v[0] * nx + v[1] * ny + v[2] * nz);
  if (f < 0) f = 0;
  return Vec3(f * nx, f * ny, f * nz);
}

std::vector<double> columnAtRest(const std::vector<double>& m, double k, double L0, double kPlane, double g) {
  auto weightFrom = [&](std::size_t i) {
    double w = 0;
    for (; i < m.size(); i++) w += m[i] * g;
    return w;
  };
  std::vector<double> z = {-weightFrom(0) / kPlane};
  for (std::size_t i = 1; i < m.size(); i++) {
    double length = L0 - weightFrom(i) / k;
    z.push_back(z.back() + length);
  }
  return z;
}

Vec3 frictionForce(const Vec3& v, const Vec3& n, double N, double mu, double c) {
  double vn = v[0] * n[0] + v[1] * n[1] + v[2] * n[2];
  double tx = v[0] - vn * n[0], ty = v[1] - vn * n[1], tz = v[2] - vn * n[2];
  double speed = std::hypot(tx, ty, tz);
  if (speed == 0) return Vec3(0, 0, 0);
  // below the limit c |v_t| v_t / |v_t| is c v_t
  if (c * speed < mu * N) return Vec3(-c * tx, -c * ty, -c * tz);
  double f = -mu * N;
  return Vec3(f * (tx / speed), f * (ty / speed), f * (tz / speed));
}
