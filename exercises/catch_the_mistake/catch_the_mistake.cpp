#include "catch_the_mistake.h"

// A test that never fails: it takes everything for right.

bool isSpringForceRight(const SpringForce& springForceOnA) {
  (void)springForceOnA;  // delete this line once you use it
  return true;
}

bool isGradientRight(const SpringEnergy& springEnergy, const EnergyGradient& energyGradient) {
  (void)springEnergy, (void)energyGradient;
  return true;
}

bool isDampingRight(const ProjectedDamping& projectedDamping) {
  (void)projectedDamping;
  return true;
}
