/// \file
/// The coefficients themselves, in extended precision: order conditions of trees, row sums, polynomials.

#include "engine/integrators/explicit/tableaus.h"

#include <gtest/gtest.h>
#include <cmath>
#include <string>

namespace muelle::engine {
namespace {

using Real = long double;

// Literals of 30 digits are rounded to 64 bits, and sums of terms up to 40 in size are left.
constexpr double roundOff = 1e-16;

/// Sum over i of w_i u_i.
Real dot(const Coefficients& w, const Coefficients& u) {
  Real sum = 0.0L;
  for (std::size_t i = 0; i < w.size(); ++i) sum += w[i] * u[i];
  return sum;
}

Coefficients power(const Coefficients& c, int p) {
  Coefficients result(c.size());
  for (std::size_t i = 0; i < c.size(); ++i) result[i] = std::pow(c[i], static_cast<Real>(p));
  for (std::size_t i = 0; p == 0 && i < c.size(); ++i) result[i] = 1.0L;
  return result;
}

Coefficients times(const std::vector<Coefficients>& a, const Coefficients& u) {
  Coefficients result(u.size(), 0.0L);
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < a[i].size(); ++j) result[i] += a[i][j] * u[j];
  }
  return result;
}

Coefficients product(const Coefficients& u, const Coefficients& w) {
  Coefficients result(u.size());
  for (std::size_t i = 0; i < u.size(); ++i) result[i] = u[i] * w[i];
  return result;
}

/// Conditions of the bushy trees (quadrature), of the tall ones, and of those with one branch c^q grafted on c^p:
/// sum b_i c_i^p sum_j a_ij c_j^q = 1 / ((q + 1)(p + q + 2)).
void expectOrder(const Coefficients& c, const std::vector<Coefficients>& a, const Coefficients& b, int order,
                 const std::string& name) {
  for (int p = 0; p < order; ++p) {
    EXPECT_NEAR(static_cast<double>(dot(b, power(c, p)) - 1.0L / (p + 1)), 0.0, roundOff) << name << " c^" << p;
  }
  for (int p = 0; p <= order - 2; ++p) {
    for (int q = 0; p + q <= order - 2; ++q) {
      const Real value = dot(b, product(power(c, p), times(a, power(c, q))));
      EXPECT_NEAR(static_cast<double>(value - 1.0L / ((q + 1) * (p + q + 2))), 0.0, roundOff)
          << name << " c^" << p << " A c^" << q;
    }
  }
  Coefficients tall = power(c, 0);
  Real factorial = 1.0L;
  for (int p = 1; p <= order; ++p) {
    factorial *= p;
    EXPECT_NEAR(static_cast<double>(dot(b, tall) - 1.0L / factorial), 0.0, roundOff) << name << " A^" << p - 1;
    tall = times(a, tall);
  }
}

Coefficients minus(const Coefficients& u, const Coefficients& w) {
  Coefficients result(u);
  for (std::size_t i = 0; i < u.size(); ++i) result[i] -= w[i];
  return result;
}

struct Named {
  std::string name;
  ButcherTableau tableau;
  int order;
};

std::vector<Named> rungeKuttas() {
  return {{"explicit Euler", explicitEulerTableau(), 1},
          {"explicit midpoint", explicitMidpointTableau(), 2},
          {"RK4", rungeKutta4Tableau(), 4},
          {"DP5", dormandPrince5Tableau(), 5},
          {"DOP853", dop853Tableau(), 8}};
}

TEST(OrderConditions, RungeKuttaOfTheirOrder) {
  for (const Named& method : rungeKuttas()) {
    const ButcherTableau& t = method.tableau;
    const Coefficients rows = times(t.a, power(t.c, 0));
    for (std::size_t i = 0; i < t.c.size(); ++i) EXPECT_NEAR(static_cast<double>(rows[i] - t.c[i]), 0.0, roundOff);
    expectOrder(t.c, t.a, t.b, method.order, method.name);
  }
}

// The next tall tree must not be met as well: the order is stated as it is, not lower.
TEST(OrderConditions, RungeKuttaOfNoHigherOrder) {
  for (const Named& method : rungeKuttas()) {
    Coefficients tall = power(method.tableau.c, 0);
    Real factorial = 1.0L;
    for (int p = 1; p <= method.order; ++p) {
      tall = times(method.tableau.a, tall);
      factorial *= p;
    }
    factorial *= method.order + 1;
    EXPECT_GT(std::abs(static_cast<double>(dot(method.tableau.b, tall) * factorial - 1.0L)), 1e-3) << method.name;
  }
}

TEST(OrderConditions, EmbeddedRungeKutta) {
  const ButcherTableau five = dormandPrince5Tableau();
  expectOrder(five.c, five.a, minus(five.b, five.error), 4, "DP5 embedded");
  const ButcherTableau eight = dop853Tableau();
  // Its error weights are of order 5 by themselves: they annihilate what orders up to 5 ask for.
  expectOrder(eight.c, eight.a, minus(eight.b, eight.error), 5, "DOP853 embedded");
}

TEST(OrderConditions, DormandPrince5EndsWhereTheNextBegins) {
  const ButcherTableau t = dormandPrince5Tableau();
  ASSERT_TRUE(t.firstSameAsLast);
  for (std::size_t j = 0; j < t.a.back().size(); ++j) EXPECT_EQ(t.a.back()[j], t.b[j]);
}

// The interpolant of DOP853 inside the step: the same trees up to order 7, with powers of theta.
TEST(OrderConditions, DenseOutputOfDop853) {
  const ButcherTableau t = dop853Tableau();
  const DenseTableau dense = dop853Dense();
  Coefficients c = t.c, b = t.b;
  std::vector<Coefficients> a = t.a;
  c.push_back(1.0L);
  a.push_back(t.b);
  for (std::size_t i = 0; i < 3; ++i) {
    c.push_back(dense.c[i]);
    a.push_back(dense.a[i]);
  }
  b.resize(16, 0.0L);
  for (const Real theta : {0.1L, 0.5L, 0.8L}) {
    const Real rest = 1.0L - theta;
    Coefficients weights(16);
    for (std::size_t j = 0; j < 16; ++j) {
      const Real start = (j == 0 ? 1.0L : 0.0L) - b[j], end = b[j] - (j == 12 ? 1.0L : 0.0L) - start;
      const Real tail = dense.d[0][j] + theta * (dense.d[1][j] + rest * (dense.d[2][j] + theta * dense.d[3][j]));
      weights[j] = theta * (b[j] + rest * (start + theta * (end + rest * tail)));
    }
    for (int p = 0; p < 7; ++p) {
      EXPECT_NEAR(static_cast<double>(dot(weights, power(c, p)) - std::pow(theta, p + 1.0L) / (p + 1)), 0.0, 1e-15);
      for (int q = 0; p + q <= 5; ++q) {
        const Real value = dot(weights, product(power(c, p), times(a, power(c, q))));
        const Real expected = std::pow(theta, p + q + 2.0L) / ((q + 1) * (p + q + 2));
        EXPECT_NEAR(static_cast<double>(value - expected), 0.0, 1e-15) << p << ' ' << q;
      }
    }
  }
}

// x'' = A(t, x): quadrature for both weights, sum_j a_ij = c_i^2/2, and grafted and tall trees.
void expectNystrom(const NystromTableau& t, const Coefficients& b, const Coefficients& bv, int order,
                   const std::string& name) {
  const Coefficients rows = times(t.a, power(t.c, 0));
  for (std::size_t i = 0; i < t.c.size(); ++i) {
    EXPECT_NEAR(static_cast<double>(rows[i] - t.c[i] * t.c[i] / 2.0L), 0.0, roundOff) << name << " row " << i;
  }
  const auto near = [&](Real value, Real expected, int p, int q, const char* what) {
    EXPECT_NEAR(static_cast<double>(value - expected), 0.0, roundOff) << name << ' ' << what << ' ' << p << ' ' << q;
  };
  for (int p = 0; p < order; ++p) near(dot(bv, power(t.c, p)), 1.0L / (p + 1), p, 0, "velocity");
  for (int p = 0; p < order - 1; ++p) near(dot(b, power(t.c, p)), 1.0L / ((p + 1) * (p + 2)), p, 0, "position");
  for (int p = 0; p <= order - 3; ++p) {
    for (int q = 0; p + q <= order - 3; ++q) {
      const Coefficients grafted = product(power(t.c, p), times(t.a, power(t.c, q)));
      const Real inner = 1.0L / ((q + 1) * (q + 2));
      near(dot(bv, grafted), inner / (p + q + 3), p, q, "velocity, grafted");
      if (p + q <= order - 4) {
        near(dot(b, grafted), inner / ((p + q + 3) * (p + q + 4)), p, q, "position, grafted");
      }
    }
  }
  Coefficients tall = power(t.c, 0);
  Real factorial = 1.0L;
  for (int p = 1; p <= order; p += 2) {
    near(dot(bv, tall), 1.0L / factorial, p, 0, "velocity, tall");
    if (p + 1 <= order) near(dot(b, tall), 1.0L / (factorial * (p + 1)), p, 0, "position, tall");
    factorial *= static_cast<Real>((p + 1) * (p + 2));
    tall = times(t.a, tall);
  }
}

TEST(OrderConditions, NystromOfTheirOrder) {
  const NystromTableau six = rkn64Tableau(), eight = nystrom8Tableau(), twelve = nystrom12Tableau();
  expectNystrom(six, six.b, six.bv, 6, "RKN6");
  expectNystrom(six, minus(six.b, six.error), minus(six.bv, six.errorv), 4, "RKN6 embedded");
  expectNystrom(eight, eight.b, eight.bv, 8, "RKN8");
  expectNystrom(twelve, twelve.b, twelve.bv, 12, "RKN12");
  expectNystrom(eight, minus(eight.b, eight.error), minus(eight.bv, eight.errorv), 6, "RKN8 embedded");
  expectNystrom(twelve, minus(twelve.b, twelve.error), minus(twelve.bv, twelve.errorv), 10, "RKN12 embedded");
}

TEST(OrderConditions, Nystrom6And8EndWhereTheNextBegins) {
  for (const NystromTableau& t : {rkn64Tableau(), nystrom8Tableau()}) {
    ASSERT_TRUE(t.firstSameAsLast);
    for (std::size_t j = 0; j < t.a.back().size(); ++j) EXPECT_EQ(t.a.back()[j], t.b[j]);
    EXPECT_EQ(t.c.back(), 1.0L);
  }
}

// Symmetric compositions of a symmetric step: sum g = 1, sum g^3 = sum g^5 = sum g^7 = 0 are the conditions on power
// sums up to order 8; the others are met by experiment (Convergence).
TEST(OrderConditions, CompositionsAreSymmetricAndCancelOddPowers) {
  const Coefficients four = yoshida4Fractions(), eight = kahanLi8Fractions();
  for (const Coefficients& fractions : {four, eight}) {
    for (std::size_t j = 0; j < fractions.size(); ++j) EXPECT_EQ(fractions[j], fractions[fractions.size() - 1 - j]);
    EXPECT_NEAR(static_cast<double>(dot(fractions, power(fractions, 0)) - 1.0L), 0.0, roundOff);
    EXPECT_NEAR(static_cast<double>(dot(fractions, power(fractions, 2))), 0.0, roundOff);
  }
  EXPECT_NEAR(static_cast<double>(dot(eight, power(eight, 4))), 0.0, roundOff);
  EXPECT_NEAR(static_cast<double>(dot(eight, power(eight, 6))), 0.0, roundOff);
}

}  // namespace
}  // namespace muelle::engine
