// loses: all; misconception: zero
#include "contact.h"

Vec3 planeContact(const Vec3&, const Vec3&, const Vec3&, const Vec3&, double, double) { return Vec3::Zero(); }

Vec3 sphereContact(const Vec3&, const Vec3&, const Vec3&, double, double, double) { return Vec3::Zero(); }

std::vector<double> columnAtRest(const std::vector<double>& m, double, double, double, double) {
  return std::vector<double>(m.size(), 0.0);
}

Vec3 frictionForce(const Vec3&, const Vec3&, double, double, double) { return Vec3::Zero(); }
