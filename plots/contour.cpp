#include "contour.h"

#include <array>

namespace muelle::plots {

namespace {

struct Corner {
  double x, y, value;
};

/// The point between two corners at which the value is `level`.
Vec3 crossing(const Corner& a, const Corner& b, double level) {
  const double s = (level - a.value) / (b.value - a.value);
  return {a.x + s * (b.x - a.x), 0.0, a.y + s * (b.y - a.y)};
}

/// The crossings on the sides of a cell, two by two: a saddle has four.
void addCell(Segments& lines, const std::array<Corner, 4>& corners, double level) {
  std::vector<Vec3> points;
  for (std::size_t i = 0; i < 4; ++i) {
    const Corner &a = corners[i], &b = corners[(i + 1) % 4];
    if ((a.value < level) != (b.value < level)) points.push_back(crossing(a, b, level));
  }
  for (std::size_t i = 0; i + 1 < points.size(); i += 2) lines.add(points[i], points[i + 1]);
}

}  // namespace

Segments contour(const Field& field, double level) {
  Segments lines;
  const std::size_t width = field.x.size();
  const auto corner = [&](std::size_t i, std::size_t j) {
    return Corner{field.x[i], field.y[j], field.values[j * width + i]};
  };
  for (std::size_t j = 0; j + 1 < field.y.size(); ++j) {
    for (std::size_t i = 0; i + 1 < width; ++i) {
      addCell(lines, {corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)}, level);
    }
  }
  return lines;
}

}  // namespace muelle::plots
