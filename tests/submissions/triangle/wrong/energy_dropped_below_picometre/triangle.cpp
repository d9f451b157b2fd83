// loses: CoincidentNodes, TinyLengths; misconception: energy_lost_when_coincident or threshold
#include "triangle.h"

using Big = long double;

static Big lengthOf(const Vec9& x, int i, int j, Big d[3]) {
  Big sum = 0;
  for (int c = 0; c < 3; ++c) {
    d[c] = Big(x[3 * i + c]) - Big(x[3 * j + c]);
    sum += d[c] * d[c];
  }
  return std::sqrt(sum);
}

Mat9 massMatrix(const Vec3& m) {
  Mat9 mass;
  mass.setZero();
  int row = 0;
  for (int node = 0; node < 3; ++node) {
    for (int axis = 0; axis < 3; ++axis, ++row) mass(row, row) = m[node];
  }
  return mass;
}

double triangleEnergy(const Vec9& x, const Vec3& k, const Vec3& L0) {
  Big energy = 0;
  Big d[3];
  for (int s = 0; s < 3; ++s) {
    const Big L = lengthOf(x, s, (s + 1) % 3, d);
    if (L < 1e-12) continue;
    const Big u = L - L0[s];
    energy += u * u * k[s] / 2;
  }
  return double(energy);
}

Vec9 triangleForce(const Vec9& x, const Vec3& k, const Vec3& L0) {
  Big force[9] = {};
  Big d[3];
  for (int s = 0; s < 3; ++s) {
    const int t = (s + 1) % 3;
    const Big L = lengthOf(x, s, t, d);
    if (L == 0) continue;
    for (int c = 0; c < 3; ++c) {
      const Big part = k[s] * (L - L0[s]) * d[c] / L;
      force[3 * s + c] -= part;
      force[3 * t + c] += part;
    }
  }
  Vec9 result;
  for (int i = 0; i < 9; ++i) result[i] = double(force[i]);
  return result;
}
