#include "spring_3d.h"

template <class A, class B>
static auto separation(const A& a, const B& b) {
  std::array<double, 3> d{};
  for (int i = 0; i < 3; i++) d[i] = a[i] - b[i];
  return d;
}

template <std::size_t N>
static double euclid(const std::array<double, N>& d) {
  double biggest = 0.0;
  for (double c : d) biggest = std::max(biggest, std::abs(c));
  if (biggest == 0.0) return 0.0;
  double sum = 0.0;
  for (double c : d) sum += (c / biggest) * (c / biggest);  // scaled: no underflow
  return biggest * std::sqrt(sum);
}

double springForceMagnitude(const Vec3& xa, const Vec3& xb, double k, double L0) {
  return -k * (euclid(separation(xa, xb)) - L0);
}

Vec3 springDirection(const Vec3& xa, const Vec3& xb) {
  const auto d = separation(xa, xb);
  const double L = euclid(d);
  if (L == 0.0) return Vec3::Zero();
  return Vec3(d[0] / L, d[1] / L, d[2] / L);
}

Vec3 springForce(const Vec3& xa, const Vec3& xb, double k, double L0) {
  return springDirection(xa, xb) * springForceMagnitude(xa, xb, k, L0);
}

Vec3 nodeAcceleration(const Vec3& x, double m, const std::vector<Attachment>& springs, double g) {
  Vec3 F(0, 0, -m * g);
  for (const Attachment& s : springs) F += springForce(x, s.x, s.k, s.L0);
  return F / m;
}
