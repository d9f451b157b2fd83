// loses: GradientValues, EnergyValues, WrongTogether, GradientEdges, EveryRightOne, ItThrew; misconception: accepts_all
#include "catch_the_mistake.h"

namespace {

const std::vector<double> lengths = {150, 3.5, 1.25, 0.5, 0.125, 1e-4, 1e-7, 1e-9, 1e-13, 1e-18, 1e-30, 1e-44, 1e-60, 1e-90, 1e-100, 0};
const std::vector<double> rests = {0, 0.75, 2.5};

template <class Verdict>
bool without_exception(Verdict verdict) {
  try {
    return verdict();
  } catch (...) {
    return false;
  }
}

}  // namespace

bool isSpringForceRight(const SpringForce& springForceOnA) {
  return without_exception([&] {
    bool ok = true;
    for (double L : lengths)
      for (double L0 : rests)
        for (double k : {0.5, 3e5}) {
          const double push = L == 0 ? 0 : k * (L0 - L);
          ok = ok && std::abs(springForceOnA(L, 0, k, L0) - push) <= 1e-9 * k * (L + L0);
          ok = ok && std::abs(springForceOnA(0, L, k, L0) + push) <= 1e-9 * k * (L + L0);
        }
    return ok;
  });
}

bool isGradientRight(const SpringEnergy&, const EnergyGradient&) { return true; }

bool isDampingRight(const ProjectedDamping& projectedDamping) {
  const Vec3 u(0.48, -0.6, 0.64), p(3, 1, -2), v(-1, 0.5, 2), w(2, 3, -0.5);
  return without_exception([&] {
    bool ok = true;
    for (double L : lengths)
      for (double d : {0.25, 30.0})
        for (int side : {-1, 1}) {
          const Vec3 q = L > 0.1 ? p : Vec3(0, 0, 0);
          const Vec3 expected = L == 0 ? Vec3(0, 0, 0) : Vec3(-d * u.dot(v - w) * u);
          ok = ok && (projectedDamping(q + side * L * u, q, v, w, d) - expected).norm() <= 1e-9 * d * 10;
          ok = ok && (projectedDamping(q + side * L * u, q, w, v, d) + expected).norm() <= 1e-9 * d * 10;
        }
    return ok;
  });
}
