// loses: all; misconception: refuses_all or zero
#include "catch_the_mistake.h"

bool isSpringForceRight(const SpringForce&) { return false; }

bool isGradientRight(const SpringEnergy&, const EnergyGradient&) { return false; }

bool isDampingRight(const ProjectedDamping&) { return false; }
