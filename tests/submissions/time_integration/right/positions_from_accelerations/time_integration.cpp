// velocities of the stages are put in beforehand, so that positions follow from accelerations alone (as Nystrom does)
#include "time_integration.h"

State explicitEulerStep(const Force& force, const VecX& m, const State& now, double h) {
  State next;
  next.t = h + now.t;
  next.v = h * force(now.t, now.x, now.v).cwiseQuotient(m) + now.v;
  next.x = h * now.v + now.x;
  return next;
}

State midpointStep(const Force& force, const VecX& m, const State& now, double h) {
  const VecX a = force(now.t, now.x, now.v).cwiseQuotient(m);
  const VecX am = force(now.t + 0.5 * h, now.x + 0.5 * h * now.v, now.v + 0.5 * h * a).cwiseQuotient(m);
  const VecX x = now.x + h * (now.v + 0.5 * h * a);
  const VecX v = now.v + h * am;
  return State{now.t + h, x, v};
}

State verletStep(const PositionForce& force, const VecX& m, const State& now, double h) {
  const VecX f0 = force(now.t, now.x);
  const VecX x = now.x + h * (now.v + (0.5 * h) * f0.cwiseQuotient(m));
  const VecX f1 = force(now.t + h, x);
  const VecX meanForce = 0.5 * (f0 + f1);
  const VecX v = now.v + h * meanForce.cwiseQuotient(m);
  return State{now.t + h, x, v};
}

State rungeKuttaStep(const Force& force, const VecX& m, const State& now, double h) {
  const VecX& x = now.x;
  const VecX& v = now.v;
  const double tm = now.t + h / 2, t1 = now.t + h;
  const double q = h * h / 4;
  const VecX a1 = force(now.t, x, v).cwiseQuotient(m);
  const VecX a2 = force(tm, x + h / 2 * v, v + h / 2 * a1).cwiseQuotient(m);
  const VecX a3 = force(tm, x + h / 2 * v + q * a1, v + h / 2 * a2).cwiseQuotient(m);
  const VecX a4 = force(t1, x + h * v + 2 * q * a2, v + h * a3).cwiseQuotient(m);
  const VecX xEnd = x + h * v + h * h / 6 * (a1 + a2 + a3);
  const VecX vEnd = v + h / 6 * (a1 + 2 * (a2 + a3) + a4);
  return State{t1, xEnd, vEnd};
}
