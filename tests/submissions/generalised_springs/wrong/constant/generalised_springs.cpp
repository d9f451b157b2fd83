// loses: all; misconception: constant
#include "generalised_springs.h"

#include <Eigen/Geometry>

double bendingAngle(const Vec9&) { return 1.5; }
double bendingEnergy(const Vec9&, double, double) { return 0.2; }
Vec9 bendingForce(const Vec9&, double, double) { return (Vec9() << 0, -1, 0, -0.5, 1, 0, 0.5, 0, 0).finished(); }
double triangleArea(const Vec9&) { return 4; }
double areaEnergy(const Vec9&, double, double) { return 5; }
Vec9 areaForce(const Vec9&, double, double) { return (Vec9() << 20, 0, 0, -20, 10, 0, 0, -10, 0).finished(); }
double tetrahedronVolume(const Vec12&) { return 4; }
double volumeEnergy(const Vec12&, double, double) { return 5; }
Vec12 volumeForce(const Vec12&, double, double) {
  return (Vec12() << 12, 0, 8, -12, 6, 0, 0, -6, 0, 0, 0, -8).finished();
}
