// loses: TriangleEnergy, TriangleForce; misconception: rope
#include "triangle.h"

class Triangle {
 public:
  Triangle(const Vec9& x, const Vec3& k, const Vec3& L0) : k_(k), L0_(L0) {
    for (int s = 0; s < 3; ++s) {
      edge_[s] = x.segment<3>(3 * second(s)) - x.segment<3>(3 * s);
      length_[s] = edge_[s].stableNorm();
    }
  }

  double energy() const {
    const Eigen::Array3d stretch = (length_ - L0_.array()).max(0.0);
    return (0.5 * k_.array() * stretch * stretch).sum();
  }

  Vec9 force() const {
    Vec9 f;
    f << tension(0) - tension(2), tension(1) - tension(0), tension(2) - tension(1);
    return f;
  }

 private:
  static int second(int s) { return s < 2 ? s + 1 : 0; }

  Vec3 tension(int s) const {
    if (length_[s] > L0_[s]) return k_[s] * (length_[s] - L0_[s]) * (edge_[s] / length_[s]);
    return Vec3::Zero();
  }

  Vec3 k_, L0_;
  Vec3 edge_[3];
  Eigen::Array3d length_;
};

Mat9 massMatrix(const Vec3& m) {
  Mat9 M = Mat9::Zero();
  for (int c = 0; c < 3; ++c) {
    M(c, c) = m[0];
    M(c + 3, c + 3) = m[1];
    M(c + 6, c + 6) = m[2];
  }
  return M;
}

double triangleEnergy(const Vec9& x, const Vec3& k, const Vec3& L0) { return Triangle(x, k, L0).energy(); }

Vec9 triangleForce(const Vec9& x, const Vec3& k, const Vec3& L0) { return Triangle(x, k, L0).force(); }
