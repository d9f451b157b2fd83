// loses: all; misconception: asked_nothing
#include "challenge.h"

VecX squeezedRabbit(const Force& force, const VecX& m, const VecX& x0, const VecX& v0) {
  (void)force, (void)m, (void)v0;
  return VecX::Constant(x0.size(), 0.1);
}

VecX stiffCloth(const Force& force, const Hessian& hessian, const VecX& m, const VecX& x0, const VecX& v0) {
  (void)force, (void)hessian, (void)m, (void)v0;
  return VecX::Constant(x0.size(), 0.1);
}

VecX bouncingBall(const Force& force, const VecX& m, const VecX& x0, const VecX& v0) {
  (void)force, (void)m, (void)v0;
  return VecX::Constant(x0.size(), 0.1);
}
