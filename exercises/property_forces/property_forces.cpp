#include "property_forces.h"

double meanHeight(const VecX& x) {
  (void)x;  // delete this line once you use it
  return 0.0;
}

double meanHeightEnergy(const VecX& x, double h0, double k) {
  (void)x, (void)h0, (void)k;
  return 0.0;
}

VecX meanHeightForce(const VecX& x, double h0, double k) {
  (void)h0, (void)k;
  return VecX::Zero(x.size());
}

double spread(const VecX& x, const VecX& m) {
  (void)x, (void)m;
  return 0.0;
}

VecX spreadGradient(const VecX& x, const VecX& m) {
  (void)m;
  return VecX::Zero(x.size());
}

double spreadEnergy(const VecX& x, const VecX& m, double R0, double k) {
  (void)x, (void)m, (void)R0, (void)k;
  return 0.0;
}

VecX spreadForce(const VecX& x, const VecX& m, double R0, double k) {
  (void)m, (void)R0, (void)k;
  return VecX::Zero(x.size());
}
