// loses: all; misconception: zero
#include "generalised_springs.h"

#include <Eigen/Geometry>  // for u.cross(w)

double bendingAngle(const Vec9& x) {
  (void)x;  // delete this line once you use it
  return 0.0;
}

double bendingEnergy(const Vec9& x, double theta0, double kb) {
  (void)x, (void)theta0, (void)kb;
  return 0.0;
}

Vec9 bendingForce(const Vec9& x, double theta0, double kb) {
  (void)x, (void)theta0, (void)kb;
  return Vec9::Zero();
}

double triangleArea(const Vec9& x) {
  (void)x;
  return 0.0;
}

double areaEnergy(const Vec9& x, double A0, double kA) {
  (void)x, (void)A0, (void)kA;
  return 0.0;
}

Vec9 areaForce(const Vec9& x, double A0, double kA) {
  (void)x, (void)A0, (void)kA;
  return Vec9::Zero();
}

double tetrahedronVolume(const Vec12& x) {
  (void)x;
  return 0.0;
}

double volumeEnergy(const Vec12& x, double V0, double kV) {
  (void)x, (void)V0, (void)kV;
  return 0.0;
}

Vec12 volumeForce(const Vec12& x, double V0, double kV) {
  (void)x, (void)V0, (void)kV;
  return Vec12::Zero();
}
