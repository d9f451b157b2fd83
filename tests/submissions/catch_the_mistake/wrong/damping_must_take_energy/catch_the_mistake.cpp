// loses: DampingValues, DampingDirections, DampingEdges, EveryRightOne, ItThrew; misconception: refuses_all
// Demands that a damper takes energy away, strictly, also where both ends move alike and there is none to take.
#include "catch_the_mistake.h"

#include <Eigen/Geometry>

#include <stdexcept>

// Each check throws Mistake, so that the functions below read as lists of statements.
struct Mistake : std::runtime_error {
  Mistake() : std::runtime_error("mistake") {}
};

static void expect(bool holds) {
  if (!holds) throw Mistake();
}

template <class Statements>
static bool holds(Statements statements) {
  try {
    statements();
  } catch (const std::exception&) {
    return false;
  }
  return true;
}

static void near(double a, double b, double size) { expect(std::fabs(a - b) <= 1e-6 * size); }

template <int n>
static void near(const Eigen::Matrix<double, n, 1>& a, const Eigen::Matrix<double, n, 1>& b, double size) {
  for (int i = 0; i < n; i++) near(a(i), b(i), size);
}

static Vec6 join(const Vec3& a, const Vec3& b) { return (Vec6() << a, b).finished(); }

bool isSpringForceRight(const SpringForce& f) {
  return holds([&] {
    // by hand: 10 N/m, 1 m
    near(f(0, 3, 10, 1), 20, 40);         // stretched, a below
    near(f(3, 0, 10, 1), -20, 40);        // stretched, a above
    near(f(0, 0.25, 10, 1), -7.5, 12.5);  // compressed
    near(f(0.25, 0, 10, 1), 7.5, 12.5);
    near(f(2, 3, 10, 1), 0, 20);   // at rest
    near(f(1, 3, 10, 0), 20, 20);  // no rest length
    near(f(3, 1, 10, 0), -20, 20);
    near(f(-1000, 1000, 1e9, 1000), 1e12, 3e12);
    near(f(1000, -1000, 1e-3, 0), -2, 2);
    near(f(-0.5, 0.25, 4, 1000), -3997, 4003);
    for (double L : {0.2, 0.7, 1.3, 5.9, 88.0, 740.0}) {
      for (double L0 : {0.0, 0.9, 61.0, 1000.0}) {
        const double size = L + L0, one = f(0, L, 1, L0);
        near(one, L - L0, size);
        for (double k : {0.003, 37.0, 8e8}) near(f(0, L, k, L0), k * one, k * size);  // proportional to k
        near(f(L, 0, 1, L0), -one, size);                                             // third law
        for (double place : {-940.3, -3.3, 17.2, 250.0}) {                            // anywhere
          near(f(place, place + L, 1, L0), one, size);
          near(f(place + L, place, 1, L0), -one, size);
        }
      }
    }
    // ever shorter: the full push
    for (int e = 0; e <= 100; e++) {
      const double L = std::pow(10., -e);
      if (e % 2)
        near(f(0, L, 5, 3), -5 * (3 - L), 5 * (3 + L));
      else
        near(f(L, 0, 5, 3), 5 * (3 - L), 5 * (3 + L));
    }
    for (double x : {0., 2.5, -77.7, 1000.})
      for (double L0 : {0., 1., 300.}) expect(f(x, x, 10, L0) == 0);
  });
}

bool isGradientRight(const SpringEnergy& E, const EnergyGradient& G) {
  return holds([&] {
    // by hand: from a to b is (2, 3, 6), 7 m long
    const Vec3 a(1, -2, 0.5), b = a + Vec3(2, 3, 6), toB(2, 3, 6);
    near(E(join(a, b), 10, 1), 180, 640);  // 10/2 6^2
    near<6>(G(join(a, b), 10, 1), 60.0 / 7 * join(-toB, toB), 80);
    near(E(join(a, b), 10, 9), 20, 2560);  // 10/2 2^2
    near<6>(G(join(a, b), 10, 9), 20.0 / 7 * join(toB, -toB), 160);
    near(E(join(a, b), 3, 0), 73.5, 147);
    near<6>(G(join(a, b), 3, 0), 3 * join(-toB, toB), 21);
    near(E(join(a, b), 3, 7), 0, 588);

    int number = 0;
    for (double L : {0.4, 1.7, 26.0}) {
      for (double L0 : {0.0, 0.8, 4.0}) {
        number++;
        const double k = number % 3 == 0 ? 40 : number % 3 == 1 ? 0.02 : 3e7;
        const Eigen::AngleAxisd turn(number, Vec3(0.6, -0.48, 0.64));
        const Vec3 from = Vec3(number, -2.1 * number, 3.3), u = turn * Vec3(0.36, 0.48, 0.8);
        const Vec6 x = join(from, from + L * u);
        const double energy = E(x, k, L0);
        const Vec6 gradient = G(x, k, L0);
        near(energy, k / 2 * (L - L0) * (L - L0), k * (L + L0) * (L + L0));
        // the slope
        const double h = 1e-5;
        for (int i = 0; i < 6; i++) {
          Vec6 more = x, less = x;
          more(i) += h;
          less(i) -= h;
          const double slope = (E(more, k, L0) - E(less, k, L0)) / (2 * h);
          expect(std::fabs(slope - gradient(i)) <= 1e-4 * k * (L + L0));
        }
        near(gradient.head<3>().dot(u), -k * (L - L0), k * (L + L0));  // no step of h in this
        // exchanged
        near(E(join(x.tail<3>(), x.head<3>()), k, L0), energy, k * (L + L0) * (L + L0));
        near<6>(G(join(x.tail<3>(), x.head<3>()), k, L0), join(gradient.tail<3>(), gradient.head<3>()), k * (L + L0));
      }
    }
    // The largest.
    const Vec3 corner(1000, 1000, 1000);
    const double L = 2000 * std::sqrt(3.0);
    near(E(join(corner, -corner), 1e9, 1000), 5e8 * (L - 1000) * (L - 1000), 1e9 * (L + 1000) * (L + 1000));
    near<6>(G(join(corner, -corner), 1e9, 1000),
            1e9 * (L - 1000) / std::sqrt(3.0) * join(Vec3(1, 1, 1), -Vec3(1, 1, 1)), 1e9 * (L + 1000));
    // along the axes
    for (int i = 0; i < 3; i++) {
      near<6>(G(join(Vec3::Zero(), 3 * Vec3::Unit(i)), 10, 1), 20 * join(-Vec3::Unit(i), Vec3::Unit(i)), 40);
      near<6>(G(join(Vec3::Unit(i) / 2, Vec3::Zero()), 10, 1), 5 * join(-Vec3::Unit(i), Vec3::Unit(i)), 15);
    }
    for (int e = 1; e <= 100; e++) {  // ever shorter
      const Vec3 u(2.0 / 7, -3.0 / 7, 6.0 / 7);
      const double length = std::pow(10., -e);
      const Vec6 x = e % 2 ? join(length * u, Vec3::Zero()) : join(Vec3::Zero(), -length * u);
      near(E(x, 5, 3), 2.5 * (3 - length) * (3 - length), 5 * (3 + length) * (3 + length));
      near<6>(G(x, 5, 3), 5 * (3 - length) * join(-u, u), 5 * (3 + length));
    }
    for (const Vec3& x : {Vec3(0, 0, 0), a, b, corner}) {
      for (double L0 : {0., 1., 300.}) {
        near(E(join(x, x), 10, L0), 5 * L0 * L0, 10 * L0 * L0);
        const Vec6 none = G(join(x, x), 10, L0);
        for (int i = 0; i < 6; i++) expect(none(i) == 0);
      }
    }
  });
}

bool isDampingRight(const ProjectedDamping& D) {
  return holds([&] {
    const Vec3 zero(0, 0, 0);
    // by hand: along (2, 3, 6) / 7; a goes along it with 7 m/s
    const Vec3 a(1, -2, 0.5), line(2, 3, 6), b = a + line;
    near<3>(D(a, b, line, zero, 10), -10 * line, 70);  // approaching
    near<3>(D(a, b, -line, zero, 10), 10 * line, 70);
    near<3>(D(a, b, zero, line, 10), 10 * line, 70);  // parting
    near<3>(D(b, a, zero, line, 10), 10 * line, 70);
    near<3>(D(a, b, Vec3(3, -2, 0), zero, 10), zero, 40);  // across
    near<3>(D(a, b, zero, Vec3(0, 2, -1), 10), zero, 40);
    near<3>(D(a, b, line, line, 10), zero, 140);                                                        // together
    for (const Vec3& v : {zero, line, Vec3(2 * line)}) expect(D(a, b, v, line, 10).dot(v - line) < 0);  // takes energy
    near<3>(D(a, b, Vec3(7, 0, 0), zero, 1), -2.0 / 7 * line, 7);

    const Vec3 va(0.9, -2.3, 1.4), vb(-1.6, 0.7, 2.2), more(5.5, 6.1, -7.3);
    int number = 0;
    for (double L : {0.02, 0.6, 3.0, 210.0}) {
      for (double angle : {0.4, 1.9, 3.5, 5.1}) {
        number++;
        const Eigen::AngleAxisd turn(angle, Vec3(0.6, -0.48, 0.64));
        const Vec3 u = turn * Vec3(0.36, 0.48, 0.8), from(number, -2.1 * number, 3.3), to = from + L * u;
        const double size = va.norm() + vb.norm();
        const Vec3 one = D(from, to, va, vb, 1);
        near<3>(u.cross(one), zero, size);  // along the spring
        near(one.dot(u), (vb - va).dot(u), size);
        expect(one.dot(va - vb) <= 1e-6 * size * size);
        near<3>(D(to, from, vb, va, 1), -one, size);                                    // third law
        near<3>(D(from, to, 100 * va, 100 * vb, 1), 100 * one, 100 * size);             // proportional
        near<3>(D(from, to, va + more, vb + more, 1), one, size + 2 * more.norm());     // a moving observer
        near<3>(D(from + 9 * more, to + 9 * more, va, vb, 1), one, size);               // elsewhere
        near<3>(D(turn * from, turn * to, turn * va, turn * vb, 1), turn * one, size);  // turned
        for (double d : {0.0, 0.07, 1e6}) near<3>(D(from, to, va, vb, d), d * one, d * size);
      }
    }
    for (int i = 0; i < 3; i++) {
      near<3>(D(zero, 3 * Vec3::Unit(i), va, vb, 10), 10 * (vb - va)(i)*Vec3::Unit(i), 100);
    }
    for (int e = 1; e <= 100; e++) {
      const Vec3 u = line / 7, x = std::pow(10., -e) * u;
      near<3>(D(x, zero, va, vb, 10), 10 * (vb - va).dot(u) * u, 100);
      const Vec3 slow = std::pow(10., -e) * va;
      near<3>(D(a, b, slow, zero, 10), -10 * slow.dot(u) * u, 10 * slow.norm());
    }
    for (const Vec3& x : {zero, a, b, more}) {
      for (const Vec3& v : {va, vb, more, zero}) {
        const Vec3 none = D(x, x, v, va, 10);
        expect(none(0) == 0 && none(1) == 0 && none(2) == 0);
      }
    }
  });
}
