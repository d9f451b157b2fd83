/// \file
/// What tests with a blind spot would say: the oracle's verdict on an implementation that is made right where they do
/// not look.

#include "catch_the_mistake.h"

#include "grader/testing/mistakes.h"

namespace {

/// Nodes nearer than this are an edge of the contract.
constexpr double near = 1e-3;  // [m]

/// How far down those go who do not stop at once.
constexpr double nanometre = 1e-9;  // [m]

// --- forces ---------------------------------------------------------------------------------------------------------

double rightForce(double xa, double xb, double k, double L0) {
  const double r = xb - xa;
  return r == 0 ? 0 : k * (r - std::copysign(L0, r));
}

using LooksAtForce = std::function<bool(double xa, double xb, double k, double L0)>;

/// The verdict of one who looks there only.
auto forceSeen(const LooksAtForce& looks) {
  return [looks](const SpringForce& f) {
    return oracle::isSpringForceRight([&](double xa, double xb, double k, double L0) {
      return looks(xa, xb, k, L0) ? f(xa, xb, k, L0) : rightForce(xa, xb, k, L0);
    });
  };
}

/// Of one who asks for coincident nodes, and for lengths down to this one [m].
auto forceSeenDownTo(double least) {
  return forceSeen([least](double xa, double xb, double, double) { return xa == xb || std::abs(xa - xb) >= least; });
}

// --- energies -------------------------------------------------------------------------------------------------------

Vec3 across(const Vec6& x) { return x.head<3>() - x.tail<3>(); }

double rightEnergy(const Vec6& x, double k, double L0) {
  const double s = across(x).norm() - L0;
  return k * s * s / 2;
}

Vec6 rightGradient(const Vec6& x, double k, double L0) {
  const double L = across(x).norm();
  Vec6 gradient = Vec6::Zero();
  if (L > 0) gradient.head<3>() = k * (L - L0) / L * across(x);
  gradient.tail<3>() = -gradient.head<3>();
  return gradient;
}

using LooksAtSpring = std::function<bool(double L, double L0)>;

auto springSeen(const LooksAtSpring& looks) {
  return [looks](const SpringEnergy& E, const EnergyGradient& dE) {
    const auto isSeen = [&](const Vec6& x, double L0) { return looks(across(x).norm(), L0); };
    return oracle::isGradientRight(
        [&](const Vec6& x, double k, double L0) { return isSeen(x, L0) ? E(x, k, L0) : rightEnergy(x, k, L0); },
        [&](const Vec6& x, double k, double L0) { return isSeen(x, L0) ? dE(x, k, L0) : rightGradient(x, k, L0); });
  };
}

auto springSeenDownTo(double least) {
  return springSeen([least](double L, double) { return L == 0 || L >= least; });
}

/// Whether the gradient is the derivative of the energy, by differences, at springs of every kind.
bool isDerivative(const SpringEnergy& E, const EnergyGradient& dE) {
  const double k = 31, step = 1e-5;
  for (const double L0 : {0.0, 0.9, 4.7}) {
    const Vec6 x = (Vec6() << 1.7, -0.4, 2.1, 0.3, 0.6, -1.2).finished();
    for (int i = 0; i < 6; ++i) {
      const Vec6 way = step * Vec6::Unit(i);
      const double slope = (E(x + way, k, L0) - E(x - way, k, L0)) / (2 * step);
      if (!(std::abs(slope - dE(x, k, L0)[i]) < 1e-4 * k)) return false;
    }
  }
  return true;
}

// --- dampings -------------------------------------------------------------------------------------------------------

Vec3 rightDamping(const Vec3& xa, const Vec3& xb, const Vec3& va, const Vec3& vb, double d) {
  const double L = (xa - xb).norm();
  if (L == 0) return Vec3::Zero();
  const Vec3 e = (xa - xb) / L;
  return d * e.dot(vb - va) * e;
}

using LooksAtDamper = std::function<bool(const Vec3& r, const Vec3& va, const Vec3& vb)>;

auto damperSeen(const LooksAtDamper& looks) {
  return [looks](const ProjectedDamping& f) {
    return oracle::isDampingRight([&](const Vec3& xa, const Vec3& xb, const Vec3& va, const Vec3& vb, double d) {
      return looks(xa - xb, va, vb) ? f(xa, xb, va, vb, d) : rightDamping(xa, xb, va, vb, d);
    });
  };
}

auto damperSeenDownTo(double least) {
  return damperSeen([least](const Vec3& r, const Vec3&, const Vec3&) { return r.isZero(0) || r.norm() >= least; });
}

/// The verdict of one who catches exceptions.
template <class Asked>
bool answersAnd(const Asked& asked) {
  try {
    return asked();
  } catch (const std::exception&) {
    return false;
  }
}

}  // namespace

MUELLE_MISTAKE(isSpringForceRight, accepts_all, [](const SpringForce&) { return true; });
MUELLE_MISTAKE(isSpringForceRight, refuses_all, [](const SpringForce&) { return false; });
MUELLE_MISTAKE(isSpringForceRight, turned_round, [](const SpringForce& f) { return !oracle::isSpringForceRight(f); });
MUELLE_MISTAKE(isSpringForceRight, stretched_only,
               forceSeen([](double xa, double xb, double, double L0) { return std::abs(xa - xb) >= L0; }));
MUELLE_MISTAKE(isSpringForceRight, one_order, forceSeen([](double xa, double xb, double, double) { return xa >= xb; }));
MUELLE_MISTAKE(isSpringForceRight, never_coincident,
               forceSeen([](double xa, double xb, double, double) { return xa != xb; }));
MUELLE_MISTAKE(isSpringForceRight, never_short, forceSeenDownTo(near));
namespace to_a_nanometre {
MUELLE_MISTAKE(isSpringForceRight, never_short, forceSeenDownTo(nanometre));
MUELLE_MISTAKE(isGradientRight, never_short, springSeenDownTo(nanometre));
MUELLE_MISTAKE(isDampingRight, never_short, damperSeenDownTo(nanometre));
}  // namespace to_a_nanometre
MUELLE_MISTAKE(isSpringForceRight, no_edges,
               forceSeen([](double xa, double xb, double, double) { return std::abs(xa - xb) >= near; }));
MUELLE_MISTAKE(isSpringForceRight, size_only, [](const SpringForce& f) {
  return oracle::isSpringForceRight([&](double xa, double xb, double k, double L0) {
    return std::copysign(f(xa, xb, k, L0), rightForce(xa, xb, k, L0));
  });
});

MUELLE_MISTAKE(isGradientRight, accepts_all, [](const SpringEnergy&, const EnergyGradient&) { return true; });
MUELLE_MISTAKE(isGradientRight, refuses_all, [](const SpringEnergy&, const EnergyGradient&) { return false; });
MUELLE_MISTAKE(isGradientRight, turned_round,
               [](const SpringEnergy& E, const EnergyGradient& dE) { return !oracle::isGradientRight(E, dE); });
MUELLE_MISTAKE(isGradientRight, law_only, [](const SpringEnergy& E, const EnergyGradient& dE) {
  return answersAnd([&] { return isDerivative(E, dE); });
});
MUELLE_MISTAKE(isGradientRight, energy_unasked,
               [](const SpringEnergy&, const EnergyGradient& dE) { return oracle::isGradientRight(rightEnergy, dE); });
MUELLE_MISTAKE(isGradientRight, gradient_unasked,
               [](const SpringEnergy& E, const EnergyGradient&) { return oracle::isGradientRight(E, rightGradient); });
MUELLE_MISTAKE(isGradientRight, stretched_only, springSeen([](double L, double L0) { return L >= L0; }));
MUELLE_MISTAKE(isGradientRight, never_coincident, springSeen([](double L, double) { return L > 0; }));
MUELLE_MISTAKE(isGradientRight, never_short, springSeenDownTo(near));
MUELLE_MISTAKE(isGradientRight, no_edges, springSeen([](double L, double) { return L >= near; }));

MUELLE_MISTAKE(isDampingRight, accepts_all, [](const ProjectedDamping&) { return true; });
MUELLE_MISTAKE(isDampingRight, refuses_all, [](const ProjectedDamping&) { return false; });
MUELLE_MISTAKE(isDampingRight, turned_round, [](const ProjectedDamping& f) { return !oracle::isDampingRight(f); });
MUELLE_MISTAKE(isDampingRight, b_at_rest, [](const ProjectedDamping& f) {
  return oracle::isDampingRight([&](const Vec3& xa, const Vec3& xb, const Vec3& va, const Vec3& vb, double d) {
    return f(xa, xb, va - vb, Vec3::Zero(), d);
  });
});
MUELLE_MISTAKE(isDampingRight, parting_only,
               damperSeen([](const Vec3& r, const Vec3& va, const Vec3& vb) { return r.dot(va - vb) >= 0; }));
MUELLE_MISTAKE(isDampingRight, never_coincident,
               damperSeen([](const Vec3& r, const Vec3&, const Vec3&) { return !r.isZero(0); }));
MUELLE_MISTAKE(isDampingRight, never_short, damperSeenDownTo(near));
MUELLE_MISTAKE(isDampingRight, no_edges,
               damperSeen([](const Vec3& r, const Vec3&, const Vec3&) { return r.norm() >= near; }));
