// loses: EveryRightOne, DampingValues, DampingDirections, DampingEdges, ItThrew; misconception: refuses_all
// The student lets the tolerance grow with the expected force, which is 0 where the motion is across the spring, instead of with d |va - vb|.
#include "catch_the_mistake.h"

#include <Eigen/Geometry>

#include <initializer_list>
#include <stdexcept>
#include <utility>

namespace {

struct Mistake : std::runtime_error {
  Mistake() : std::runtime_error("mistake found") {}
};

void require(bool holds) {
  if (!holds) throw Mistake();
}

/// Answers that are to be about so many newtons or joules, with what they are measured by.
class Scale {
 public:
  explicit Scale(double size) : tolerance_(3e-9 * size) {}

  void compare(double got, double expected) const { require(std::abs(got - expected) <= tolerance_); }

  template <int n>
  void compare(const Eigen::Matrix<double, n, 1>& got, const Eigen::Matrix<double, n, 1>& expected) const {
    const Eigen::Matrix<double, n, 1> difference = got - expected;
    require(difference.allFinite() && difference.norm() <= tolerance_);
  }

 private:
  double tolerance_;
};

/// Unit vectors with rational components: no axis, one with a zero, and the axes themselves.
const std::vector<Vec3> directions = {Vec3(1, 2, 2) / 3,   Vec3(-2, 3, 6) / 7, Vec3(4, -4, 7) / 9, Vec3(0.6, 0, -0.8),
                                      Vec3(-1, 0, 0),      Vec3(0, 1, 0),      Vec3(0, 0, -1)};

template <class Questions>
bool findsNothing(Questions&& ask) {
  try {
    std::forward<Questions>(ask)();
  } catch (const std::exception&) {  // theirs, or a Mistake
    return false;
  }
  return true;
}

/// A hundred lengths that a contract allows and nobody draws.
template <class Action>
void forShortLengths(const Action& action) {
  for (int exponent = -1; exponent >= -100; --exponent) action(1.5 * std::pow(10.0, exponent));
}

class ForceScene {
 public:
  explicit ForceScene(const SpringForce& force) : force_(force) {}

  /// Both orders of a spring whose upper end is at `top`.
  void ask(double top, double L, double k, double L0) const {
    const double bottom = top - L;
    const double actual = top - bottom;  // what is left of L after rounding
    const Scale scale(k * (actual + L0));
    scale.compare(force_(top, bottom, k, L0), k * (L0 - actual));
    scale.compare(force_(bottom, top, k, L0), k * (actual - L0));
  }

  void askTogether(double x, double k, double L0) const { require(force_(x, x, k, L0) == 0.0); }

 private:
  const SpringForce& force_;
};

class EnergyScene {
 public:
  EnergyScene(const SpringEnergy& energy, const EnergyGradient& gradient) : energy_(energy), gradient_(gradient) {}

  void ask(const Vec3& u, double L, double k, double L0) const {
    Vec6 x, along;
    x << L * u, Vec3::Zero();
    along << u, -u;
    const double stretch = L - L0, size = L + L0;
    Scale(k * size * size).compare(energy_(x, k, L0), k * stretch * stretch / 2);
    Scale(k * size).compare(gradient_(x, k, L0), Vec6(k * stretch * along));
  }

  /// Elsewhere, where the ends are not symmetric.
  void askAt(const Vec3& b, const Vec3& u, double L, double k, double L0) const {
    Vec6 x, along;
    x << b + L * u, b;
    along << u, -u;
    const double stretch = L - L0, size = L + L0;
    Scale(k * size * size).compare(energy_(x, k, L0), k * stretch * stretch / 2);
    Scale(k * size).compare(gradient_(x, k, L0), Vec6(k * stretch * along));
  }

  void askTogether(const Vec3& p, double k, double L0) const {
    Vec6 x;
    x << p, p;
    Scale(k * L0 * L0).compare(energy_(x, k, L0), k * L0 * L0 / 2);
    require(gradient_(x, k, L0) == Vec6::Zero());
  }

 private:
  const SpringEnergy& energy_;
  const EnergyGradient& gradient_;
};

class DampingScene {
 public:
  explicit DampingScene(const ProjectedDamping& damping) : damping_(damping) {}

  /// \param along   rate at which the length grows   \param across  velocity at right angles to u
  void ask(const Vec3& b, const Vec3& u, double L, double along, const Vec3& across, double d) const {
    const Vec3 a = b + L * u, v = along * u + across, half = v / 2, none = Vec3::Zero();
    const Vec3 expected = -d * along * u;
    const Scale scale(expected.norm());
    scale.compare(damping_(a, b, v, none, d), expected);
    scale.compare(damping_(a, b, none, -v, d), expected);
    scale.compare(damping_(a, b, half, -half, d), expected);
    scale.compare(damping_(b, a, -half, half, d), Vec3(-expected));
  }

  void askTogether(const Vec3& p, const Vec3& va, const Vec3& vb, double d) const {
    require(damping_(p, p, va, vb, d) == Vec3::Zero());
  }

  void askSideBySide(const Vec3& a, const Vec3& b, const Vec3& v, double d) const {
    require(damping_(a, b, v, v, d) == Vec3::Zero());
  }

 private:
  const ProjectedDamping& damping_;
};

}  // namespace

bool isSpringForceRight(const SpringForce& springForceOnA) {
  return findsNothing([&] {
    const ForceScene scene(springForceOnA);
    for (double top : {0.0, 0.75, 13.5, -6.5}) {
      for (double L : {0.375, 1.75, 2.0, 11.0}) {
        for (double L0 : {0.0, 0.5, 2.0, 30.0}) scene.ask(top, L, 12, L0);
      }
    }
    for (double k : {1e-3, 1.0, 1e9}) {
      scene.ask(1000, 2000, k, 1000);
      scene.ask(1000, 2000, k, 0);
      scene.ask(-990, 10, k, 1000);
      scene.ask(0.25, 0.5, k, 0.75);
    }
    forShortLengths([&](double L) { scene.ask(0, L, 12, 1.5); });
    for (double L : {1e-3, 1e-7, 1e-11, 1e-30, 2e-100}) scene.ask(L, L, 12, 0);
    for (double x : {0.0, 2.5, -1000.0}) {
      for (double L0 : {0.0, 1.5, 1000.0}) scene.askTogether(x, 12, L0);
    }
  });
}

bool isGradientRight(const SpringEnergy& springEnergy, const EnergyGradient& energyGradient) {
  return findsNothing([&] {
    const EnergyScene scene(springEnergy, energyGradient);
    for (const Vec3& u : directions) {
      for (double L0 : {0.0, 0.5, 2.0, 9.0}) {
        scene.ask(u, 0.75, 12, L0);
        scene.askAt(Vec3(-1, 5, 2.5), u, 3.5, 12, L0);
      }
      scene.askAt(Vec3(3, 2, 1), -u, 2, 12, 2);
    }
    for (double k : {1e-3, 1.0, 1e9}) {
      scene.ask(directions[1], 980, k, 10);
      scene.ask(directions[2], 0.5, k, 1000);
    }
    forShortLengths([&](double L) { scene.ask(directions[0], L, 12, 1.5); });
    for (double L : {1e-3, 1e-7, 1e-11, 1e-30, 2e-100}) scene.ask(directions[1], L, 12, 0);
    for (double L0 : {0.0, 1.5, 1000.0}) {
      scene.askTogether(Vec3(0, 0, 0), 12, L0);
      scene.askTogether(Vec3(1, -2, 30), 3, L0);
    }
  });
}

bool isDampingRight(const ProjectedDamping& projectedDamping) {
  return findsNothing([&] {
    const DampingScene scene(projectedDamping);
    for (const Vec3& u : directions) {
      const Vec3 across = u.unitOrthogonal();
      scene.ask(Vec3(0, 0, 0), u, 0.5, 3, Vec3(0, 0, 0), 4);
      scene.ask(Vec3(1, -2, 7), u, 2.5, -3, 2 * across, 4);
      scene.ask(Vec3(1, -2, 7), u, 4, 0, 2 * across, 0.3);
      scene.ask(Vec3(-8, 0, 1), u, 3, 0.2, -5 * across, 1e3);
    }
    scene.ask(Vec3(-500, 0, 0), Vec3(1, 0, 0), 1200, 900, Vec3(0, 100, 0), 1e6);
    scene.ask(Vec3(1, 2, 3), Vec3(0, 0, 1), 2, -5, Vec3(0, 1, 0), 0);
    forShortLengths([&](double L) {
      const Vec3 u = directions[0], xa = L * u, xb = Vec3::Zero(), across = u.unitOrthogonal();
      const Scale scale(4 * 6);
      scale.compare(projectedDamping(xa, xb, Vec3(4 * u + across), Vec3(-u), 4), Vec3(-20 * u));
      scale.compare(projectedDamping(xa, xb, Vec3(-u), Vec3(4 * u + across), 4), Vec3(20 * u));
    });
    const Vec3 p(1, -2, 30), o(0, 0, 0), v(2, 3, -1), w(0, 0, 5);
    for (double d : {0.0, 4.0, 1e6}) {
      scene.askTogether(p, v, w, d);
      scene.askTogether(o, v, o, d);
      scene.askTogether(o, w, w, d);
      scene.askSideBySide(p, o, v, d);
      scene.askSideBySide(o, p, w, d);
    }
  });
}
