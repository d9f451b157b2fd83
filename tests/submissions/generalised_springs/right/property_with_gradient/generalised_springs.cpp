#include "generalised_springs.h"

#include <Eigen/Geometry>  // for u.cross(w)

namespace {

/// A number p of N / 3 nodes, and how it grows when these move.
template <int N>
struct Property {
  double value = 0.0;
  Eigen::Matrix<double, N, 1> gradient = Eigen::Matrix<double, N, 1>::Zero();

  double energy(double rest, double k) const { return 0.5 * k * (value - rest) * (value - rest); }
  Eigen::Matrix<double, N, 1> force(double rest, double k) const { return k * (rest - value) * gradient; }
};

/// Node i, counted round the end.
template <int N>
Vec3 node(const Eigen::Matrix<double, N, 1>& x, int i) {
  return x.template segment<3>(3 * (i % (N / 3)));
}

bool segmentMissing(const Vec9& x) {
  return node<9>(x, 0) == node<9>(x, 1) || node<9>(x, 1) == node<9>(x, 2);
}

/// The turn of a segment about the cross product c: at right angles to both, over the square of the length.
Vec3 turn(const Vec3& c, const Vec3& segment) { return c.cross(segment) / c.norm() / segment.squaredNorm(); }

Property<9> bend(const Vec9& x) {
  const Vec3 back = node<9>(x, 0) - node<9>(x, 1);  // from the middle to either side
  const Vec3 forth = node<9>(x, 2) - node<9>(x, 1);
  const Vec3 c = forth.cross(back);
  Property<9> angle;
  angle.value = std::atan2(c.norm(), -back.dot(forth));
  if (c.isZero(0)) return angle;
  const Vec3 first = -turn(c, back), last = turn(c, forth);
  angle.gradient << first, -first - last, last;
  return angle;
}

Property<9> area(const Vec9& x) {
  const Vec3 c = (node<9>(x, 2) - node<9>(x, 1)).cross(node<9>(x, 0) - node<9>(x, 1));
  Property<9> result;
  result.value = c.norm() / 2;
  if (c.norm() == 0) return result;
  for (int i = 0; i < 3; ++i) {
    const Vec3 opposite = node<9>(x, i + 2) - node<9>(x, i + 1);
    result.gradient.segment<3>(3 * i) = c.cross(opposite) / (2 * c.norm());
  }
  return result;
}

Property<12> volume(const Vec12& x) {
  Property<12> result;
  // Three edges one after the other span the same as the three from node 0.
  const Vec3 e = node<12>(x, 1) - node<12>(x, 0), f = node<12>(x, 2) - node<12>(x, 1), g = node<12>(x, 3) - node<12>(x, 2);
  result.value = e.cross(f).dot(g) / 6;
  // Each node moves up from the face of the three others; round the nodes the faces look in and out in turns.
  double side = -1;
  for (int i = 0; i < 4; ++i, side = -side) {
    const Vec3 p = node<12>(x, i + 1), q = node<12>(x, i + 2), r = node<12>(x, i + 3);
    result.gradient.segment<3>(3 * i) = side / 6 * (q - p).cross(r - p);
  }
  return result;
}

}  // namespace

double bendingAngle(const Vec9& x) { return bend(x).value; }

double bendingEnergy(const Vec9& x, double theta0, double kb) {
  return segmentMissing(x) ? 0.0 : bend(x).energy(theta0, kb);
}

Vec9 bendingForce(const Vec9& x, double theta0, double kb) { return bend(x).force(theta0, kb); }

double triangleArea(const Vec9& x) { return area(x).value; }

double areaEnergy(const Vec9& x, double A0, double kA) { return area(x).energy(A0, kA); }

Vec9 areaForce(const Vec9& x, double A0, double kA) { return area(x).force(A0, kA); }

double tetrahedronVolume(const Vec12& x) { return volume(x).value; }

double volumeEnergy(const Vec12& x, double V0, double kV) { return volume(x).energy(V0, kV); }

Vec12 volumeForce(const Vec12& x, double V0, double kV) { return volume(x).force(V0, kV); }
