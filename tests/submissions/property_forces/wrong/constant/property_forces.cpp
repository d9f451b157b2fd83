// loses: all; misconception: constant
#include "property_forces.h"

double meanHeight(const VecX&) { return 2.0; }
double meanHeightEnergy(const VecX&, double, double) { return 5.0; }
VecX meanHeightForce(const VecX& x, double, double) { return VecX::Constant(x.size(), -4.0); }
double spread(const VecX&, const VecX&) { return 2.0; }
VecX spreadGradient(const VecX& x, const VecX&) { return VecX::Constant(x.size(), 0.4); }
double spreadEnergy(const VecX&, const VecX&, double, double) { return 5.0; }
VecX spreadForce(const VecX& x, const VecX&, double, double) { return VecX::Constant(x.size(), 4.0); }
