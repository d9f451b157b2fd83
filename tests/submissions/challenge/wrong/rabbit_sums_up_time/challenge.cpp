// loses: RabbitEnough, RabbitGood, RabbitBest; misconception: another_time
// Adds up the steps of the rabbit and goes on while the sum is less than the end: by round-off that is one step too
// many.
#include "challenge.h"

#include <Eigen/SparseCholesky>

namespace {

struct Body {
  VecX x, v;
};

// One step of the classical method.
Body rk4(const Force& force, const VecX& m, double t, double h, const Body& b) {
  const VecX a1 = force(t, b.x, b.v).array() / m.array();
  const VecX v2 = b.v + h / 2 * a1;
  const VecX a2 = force(t + h / 2, b.x + h / 2 * b.v, v2).array() / m.array();
  const VecX v3 = b.v + h / 2 * a2;
  const VecX a3 = force(t + h / 2, b.x + h / 2 * v2, v3).array() / m.array();
  const VecX v4 = b.v + h * a3;
  const VecX a4 = force(t + h, b.x + h * v3, v4).array() / m.array();
  return {b.x + h / 6 * (b.v + 2 * v2 + 2 * v3 + v4), b.v + h / 6 * (a1 + 2 * a2 + 2 * a3 + a4)};
}

// When a ball at height z with velocity w upwards meets the ground, about.
double timeToGround(double z, double w) {
  const double g = 9.8;
  return (w + std::sqrt(w * w + 2 * g * std::max(z, 0.0))) / g;
}

}  // namespace

VecX squeezedRabbit(const Force& force, const VecX& m, const VecX& x0, const VecX& v0) {
  const double h = rabbitDuration / 119;
  Body body{x0, v0};
  for (double t = 0; t < rabbitDuration; t += h) body = rk4(force, m, t, h, body);
  return body.x;
}

VecX stiffCloth(const Force& force, const Hessian& hessian, const VecX& m, const VecX& x0, const VecX& v0) {
  const int steps = 110;
  const double h = clothDuration / steps;
  Eigen::SparseMatrix<double> mass(m.size(), m.size());
  mass.setIdentity();
  mass.diagonal() = m;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> ldlt;

  VecX x = x0, v = v0;
  VecX a = force(0, x, v).cwiseQuotient(m);
  for (int i = 0; i < steps; i++) {
    const double end = (i + 1) * h;
    VecX next = x + h * v;  // a guess
    const Eigen::SparseMatrix<double> A = mass + h * h / 4 * hessian(end, next);
    ldlt.compute(A);
    // M (next - x - h v - h^2/4 a) = h^2/4 F(next)
    for (int turn = 0; turn < 2; turn++) {
      const VecX F = force(end, next, v);
      const VecX residual = m.cwiseProduct(next - x - h * v - h * h / 4 * a) - h * h / 4 * F;
      next -= ldlt.solve(residual);
    }
    const VecX aNext = 4 / (h * h) * (next - x - h * v) - a;
    x = next;
    v += h / 2 * (a + aNext);
    a = aNext;
  }
  return x;
}

VecX bouncingBall(const Force& force, const VecX& m, const VecX& x0, const VecX& v0) {
  const double flying = 0.02, touching = 2e-4;
  Body ball{x0, v0};
  double t = 0;
  while (t < ballDuration - 1e-13) {
    const double z = ball.x[2], w = ball.v[2];
    double h = touching;
    if (z > 0) {
      const double left = timeToGround(z, w);
      h = std::min(flying, 0.9 * left);
      if (h < touching) h = touching;
    }
    h = std::min(h, ballDuration - t);
    ball = rk4(force, m, t, h, ball);
    t += h;
  }
  return ball.x;
}
