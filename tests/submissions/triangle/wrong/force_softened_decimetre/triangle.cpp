// loses: TriangleForce, MinusTheGradient; misconception: softened_length
#include "triangle.h"

namespace {

template <int Node>
Vec3 at(const Vec9& x) {
  return x.segment<3>(3 * Node);
}

template <int S>
double energyOfSpring(const Vec9& x, const Vec3& k, const Vec3& L0) {
  constexpr int next = (S + 1) % 3;
  const double u = (at<S>(x) - at<next>(x)).stableNorm() - L0[S];
  return 0.5 * k[S] * u * u;
}

template <int S>
void addForceOfSpring(const Vec9& x, const Vec3& k, const Vec3& L0, Vec9& F) {
  constexpr int next = (S + 1) % 3;
  const Vec3 r = at<S>(x) - at<next>(x);
  const double L = r.stableNorm();
  if (L > 0) {
    const Vec3 gradient = k[S] * (L - L0[S]) * r / std::sqrt(L * L + 1e-2);
    F.segment<3>(3 * S) -= gradient;
    F.segment<3>(3 * next) += gradient;
  }
}

}  // namespace

Mat9 massMatrix(const Vec3& m) {
  return (Vec9() << Vec3::Constant(m[0]), Vec3::Constant(m[1]), Vec3::Constant(m[2])).finished().asDiagonal();
}

double triangleEnergy(const Vec9& x, const Vec3& k, const Vec3& L0) {
  return energyOfSpring<0>(x, k, L0) + energyOfSpring<1>(x, k, L0) + energyOfSpring<2>(x, k, L0);
}

Vec9 triangleForce(const Vec9& x, const Vec3& k, const Vec3& L0) {
  Vec9 F = Vec9::Zero();
  addForceOfSpring<0>(x, k, L0, F);
  addForceOfSpring<1>(x, k, L0, F);
  addForceOfSpring<2>(x, k, L0, F);
  return F;
}
