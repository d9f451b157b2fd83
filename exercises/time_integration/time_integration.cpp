#include "time_integration.h"

State explicitEulerStep(const Force& force, const VecX& m, const State& now, double h) {
  (void)force, (void)m, (void)h;  // delete this line once you use them
  return {0.0, VecX::Zero(now.x.size()), VecX::Zero(now.v.size())};
}

State midpointStep(const Force& force, const VecX& m, const State& now, double h) {
  (void)force, (void)m, (void)h;
  return {0.0, VecX::Zero(now.x.size()), VecX::Zero(now.v.size())};
}

State verletStep(const PositionForce& force, const VecX& m, const State& now, double h) {
  (void)force, (void)m, (void)h;
  return {0.0, VecX::Zero(now.x.size()), VecX::Zero(now.v.size())};
}

State rungeKuttaStep(const Force& force, const VecX& m, const State& now, double h) {
  (void)force, (void)m, (void)h;
  return {0.0, VecX::Zero(now.x.size()), VecX::Zero(now.v.size())};
}
