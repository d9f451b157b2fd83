// loses: all; misconception: accepts_all
#include "catch_the_mistake.h"

bool isSpringForceRight(const SpringForce&) { return true; }

bool isGradientRight(const SpringEnergy&, const EnergyGradient&) { return true; }

bool isDampingRight(const ProjectedDamping&) { return true; }
