// loses: all; misconception: constant
#include "contact.h"

Vec3 planeContact(const Vec3&, const Vec3&, const Vec3&, const Vec3&, double, double) { return {1, -2, 3}; }

Vec3 sphereContact(const Vec3&, const Vec3&, const Vec3&, double, double, double) { return {1, -2, 3}; }

std::vector<double> columnAtRest(const std::vector<double>& m, double, double, double, double) {
  return std::vector<double>(m.size(), 0.25);
}

Vec3 frictionForce(const Vec3&, const Vec3&, double, double, double) { return {1, -2, 3}; }
