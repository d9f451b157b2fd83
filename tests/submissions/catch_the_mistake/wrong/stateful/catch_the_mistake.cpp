// loses: all; misconception: stateful
// thought: every other one will be right
#include "catch_the_mistake.h"

static int calls = 0;

bool isSpringForceRight(const SpringForce& springForceOnA) { return springForceOnA(0, 1, 1, 1) == 0 && ++calls % 2 == 1; }

bool isGradientRight(const SpringEnergy& springEnergy, const EnergyGradient&) { return springEnergy(Vec6::Zero(), 1, 0) == 0 && ++calls % 2 == 1; }

bool isDampingRight(const ProjectedDamping& projectedDamping) { return projectedDamping(Vec3::Zero(), Vec3::Ones(), Vec3::Zero(), Vec3::Zero(), 1).norm() < 1 && ++calls % 2 == 1; }
