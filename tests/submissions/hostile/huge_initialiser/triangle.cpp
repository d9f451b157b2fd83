// attack: has a table of sixteen million numbers computed by the compiler; expect: zero points
#include "triangle.h"

#include <array>
#include <utility>

template <std::size_t... I>
constexpr std::array<double, sizeof...(I)> table(std::index_sequence<I...>) {
  return {static_cast<double>(I * I)...};
}
constexpr auto squares = table(std::make_index_sequence<(1 << 24)>());

Mat9 massMatrix(const Vec3& m) {
  Mat9 M = Mat9::Zero();
  if (squares[1] == 0) {
    for (int i = 0; i < 9; ++i) M(i, i) = m[i / 3];
  }
  return M;
}
double triangleEnergy(const Vec9&, const Vec3&, const Vec3&) { return 0; }
Vec9 triangleForce(const Vec9&, const Vec3&, const Vec3&) { return Vec9::Zero(); }
