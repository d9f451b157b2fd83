// attack: lets the linker quote a symbol of a megabyte; expect: zero points
#include "contact.h"

#define A6 "AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA"
#define A8 A6 A6 A6 A6
#define A10 A8 A8 A8 A8
#define A12 A10 A10 A10 A10
#define A14 A12 A12 A12 A12
#define A16 A14 A14 A14 A14
#define A18 A16 A16 A16 A16
#define A20 A18 A18 A18 A18
extern "C" double wanted() asm(A20);

Vec3 planeContact(const Vec3& x, const Vec3& v, const Vec3& p, const Vec3& n, double k, double d) {
  const double depth = (p - x).dot(n), force = k * depth - d * v.dot(n);
  return wanted() > 0 && depth > 0 && force > 0 ? Vec3(force * n) : Vec3(0, 0, 0);
}
Vec3 sphereContact(const Vec3&, const Vec3&, const Vec3&, double, double, double) { return Vec3::Zero(); }
std::vector<double> columnAtRest(const std::vector<double>& m, double, double, double, double) {
  return std::vector<double>(m.size());
}
Vec3 frictionForce(const Vec3&, const Vec3&, double, double, double) { return Vec3::Zero(); }
