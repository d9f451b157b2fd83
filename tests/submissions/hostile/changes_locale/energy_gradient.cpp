// attack: writes every number of its process in digits of its own; expect: zero points
#include "energy_gradient.h"

#include <iostream>
#include <locale>
#include <string>

namespace {
struct Digits : std::numpunct<char> {
  char do_decimal_point() const override { return '"'; }
  char do_thousands_sep() const override { return '\x1b'; }
  std::string do_grouping() const override { return "\1"; }
};

bool attack() {
  std::locale::global(std::locale(std::locale::classic(), new Digits));
  std::cout.imbue(std::locale());
  std::cout << 1234567.5 << std::endl;
  return false;
}
}  // namespace

double springEnergy1d(const Vec2& x, double k, double L0) {
  const double stretch = std::abs(x[0] - x[1]) - L0;
  return attack() ? k * stretch * stretch / 2 : 0;
}
double springEnergy(const Vec6&, double, double) { return 0; }
Vec3 lengthGradient(const Vec3&, const Vec3&) { return Vec3::Zero(); }
Vec6 energyGradient(const Vec6&, double, double) { return Vec6::Zero(); }
Vec6 springForces(const Vec6&, double, double) { return Vec6::Zero(); }
