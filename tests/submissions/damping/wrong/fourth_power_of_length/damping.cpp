// loses: ShortSpring; misconception: threshold
// d L Ldot r / L^2 with L Ldot = v.r, written with L^2 twice: equal in algebra, but L^4 is 0 at L = 1e-100
#include "damping.h"

Vec3 nodeDamping(const Vec3& va, double d) { return -d * va; }

Vec3 relativeDamping(const Vec3& va, const Vec3& vb, double d) { return -d * (va - vb); }

Vec3 projectedDamping(const Vec3& xa, const Vec3& xb, const Vec3& va, const Vec3& vb, double d) {
  const Vec3 r = xa - xb;
  const double square = r.squaredNorm();
  if (square == 0) return Vec3::Zero();
  const double squareRate = 2 * (va - vb).dot(r);        // of L^2
  const Vec3 gradientOfSquare = 2 * r;                   // of L^2
  return -d * squareRate * square * gradientOfSquare / (4 * square * square);
}
