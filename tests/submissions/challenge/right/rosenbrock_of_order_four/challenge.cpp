#include "challenge.h"

#include <Eigen/SparseCholesky>

namespace {

struct Motion {
  VecX x, v;
};

/// Runge-Kutta 4
void step(const Force& force, const VecX& m, double t, double h, Motion& s) {
  auto a = [&](double time, const VecX& x, const VecX& v) { return VecX(force(time, x, v).cwiseQuotient(m)); };
  const VecX v1 = s.v, a1 = a(t, s.x, v1);
  const VecX v2 = s.v + h / 2 * a1, a2 = a(t + h / 2, s.x + h / 2 * v1, v2);
  const VecX v3 = s.v + h / 2 * a2, a3 = a(t + h / 2, s.x + h / 2 * v2, v3);
  const VecX v4 = s.v + h * a3, a4 = a(t + h, s.x + h * v3, v4);
  s.x += h / 6 * (v1 + 2 * v2 + 2 * v3 + v4);
  s.v += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
}

}  // namespace

VecX squeezedRabbit(const Force& force, const VecX& m, const VecX& x0, const VecX& v0) {
  Motion s{x0, v0};
  const int n = 120;
  for (int i = 0; i < n; ++i) step(force, m, i * rabbitDuration / n, rabbitDuration / n, s);
  return s.x;
}

VecX stiffCloth(const Force& force, const Hessian& hessian, const VecX& m, const VecX& x0, const VecX& v0) {
  // Rosenbrock's method RODAS, order four, six stages
  constexpr int n = 84;
  constexpr double h = clothDuration / n, q = h / 4;
  const std::vector<std::vector<double>> A = {
      {},
      {1.544},
      {0.9466785280815826, 0.2557011698983284},
      {3.314825187068521, 2.896124015972201, 0.9986419139977817},
      {1.221224509226641, 6.019134481288629, 12.53708332932087, -0.6878860361058950},
      {1.221224509226641, 6.019134481288629, 12.53708332932087, -0.6878860361058950, 1}};
  const std::vector<std::vector<double>> C = {
      {},
      {-5.6688},
      {-2.430093356833875, -0.2063599157091915},
      {-0.1073529058151375, -9.594562251023355, -20.47028614809616},
      {7.496443313967647, -10.24680431464352, -33.99990352819905, 11.70890893206160},
      {8.083246795921522, -7.981132988064893, -31.52159432874371, 16.31930543123136, -6.058818238834054}};
  VecX x = x0, v = v0;
  for (int i = 0; i < n; ++i) {
    const Eigen::SparseMatrix<double> K = hessian(i * h, x);
    Eigen::SparseMatrix<double> left = q * q * K;
    left.diagonal() += m;
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(left);
    std::vector<VecX> ux, uv;
    VecX endX, endV;
    for (std::size_t s = 0; s < 6; ++s) {
      endX = x;
      endV = v;
      for (std::size_t j = 0; j < s; ++j) {
        endX += A[s][j] * ux[j];
        endV += A[s][j] * uv[j];
      }
      VecX rx = endV, rv = force(i * h, endX, endV);
      for (std::size_t j = 0; j < s; ++j) {
        rx += C[s][j] / h * ux[j];
        rv += C[s][j] / h * m.cwiseProduct(uv[j]);
      }
      const VecX w = solver.solve(q * rv - q * q * (K * rx));
      uv.push_back(w);
      ux.push_back(q * (rx + w));
    }
    x = endX + ux.back();
    v = endV + uv.back();
  }
  return x;
}

VecX bouncingBall(const Force& force, const VecX& m, const VecX& x0, const VecX& v0) {
  Motion s{x0, v0};
  double t = 0;
  while (t < ballDuration - 1e-12) {
    double h = 4e-4;
    if (s.x[2] > 0) {
      // when it would be at the ground, without air
      const double fall = (s.v[2] + std::sqrt(s.v[2] * s.v[2] + 2 * 9.81 * s.x[2])) / 9.81;
      h = std::min(0.05, std::max(4e-4, fall - 4e-4));
    }
    h = std::min(h, ballDuration - t);
    step(force, m, t, h, s);
    t += h;
  }
  return s.x;
}
