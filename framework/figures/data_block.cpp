#include "figures/data_block.h"

#include "figures/axis.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace muelle {

namespace {

struct Point {
  double x;
  double y;
  bool isGap() const { return std::isnan(x); }
};

constexpr Point gap{std::numeric_limits<double>::quiet_NaN(), 0.0};

/// The points of a curve with single gaps between them, none at either end.
std::vector<Point> drawablePoints(const Series& series, bool logX, bool logY) {
  std::vector<Point> points;
  for (std::size_t i = 0; i < series.x.size(); ++i) {
    if (isDrawable(series.x[i], logX) && isDrawable(series.y[i], logY)) {
      points.push_back({series.x[i], series.y[i]});
    } else if (!points.empty() && !points.back().isGap()) {
      points.push_back(gap);
    }
  }
  if (!points.empty() && points.back().isGap()) points.pop_back();
  return points;
}

bool xNeverFalls(const std::vector<Point>& points) {
  double previous = -std::numeric_limits<double>::infinity();
  for (const Point& point : points) {
    if (point.isGap()) continue;
    if (point.x < previous) return false;
    previous = point.x;
  }
  return true;
}

/// First, lowest, highest and last point of [begin, end), in their order.
void keepExtremes(const std::vector<Point>& points, std::size_t begin, std::size_t end, std::vector<Point>& kept) {
  const auto first = points.begin() + static_cast<std::ptrdiff_t>(begin);
  const auto last = points.begin() + static_cast<std::ptrdiff_t>(end);
  const auto [low, high] = std::minmax_element(first, last, [](const Point& a, const Point& b) { return a.y < b.y; });
  std::size_t chosen[] = {begin, static_cast<std::size_t>(low - points.begin()),
                          static_cast<std::size_t>(high - points.begin()), end - 1};
  std::sort(std::begin(chosen), std::end(chosen));
  const auto unique = std::unique(std::begin(chosen), std::end(chosen));
  for (auto it = std::begin(chosen); it != unique; ++it) kept.push_back(points[*it]);
}

std::vector<Point> thinnedByStretches(const std::vector<Point>& points) {
  constexpr double stretches = 800.0;
  const double low = points.front().x;
  const double width = points.back().x - low;
  const auto stretch = [&](const Point& p) { return width > 0 ? std::floor((p.x - low) / width * stretches) : 0.0; };
  std::vector<Point> kept;
  for (std::size_t begin = 0; begin < points.size();) {
    if (points[begin].isGap()) {
      kept.push_back(points[begin++]);
      continue;
    }
    std::size_t end = begin + 1;
    while (end < points.size() && !points[end].isGap() && stretch(points[end]) == stretch(points[begin])) ++end;
    keepExtremes(points, begin, end, kept);
    begin = end;
  }
  return kept;
}

std::vector<Point> thinnedByDistance(const std::vector<Point>& points) {
  AxisFitter xs(false);
  AxisFitter ys(false);
  for (const Point& point : points) {
    if (point.isGap()) continue;
    xs.include(point.x);
    ys.include(point.y);
  }
  const double near = 1.0 / 2000.0;
  const double dx = near * xs.range(0).span();
  const double dy = near * ys.range(0).span();
  std::vector<Point> kept;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const bool isEnd = i + 1 == points.size() || points[i + 1].isGap() || kept.empty() || kept.back().isGap();
    const bool isApart =
        isEnd || std::abs(points[i].x - kept.back().x) > dx || std::abs(points[i].y - kept.back().y) > dy;
    if (points[i].isGap() || isApart) kept.push_back(points[i]);
  }
  return kept;
}

}  // namespace

std::string dataBlock(const Series& series, bool logX, bool logY) {
  std::vector<Point> points = drawablePoints(series, logX, logY);
  constexpr std::size_t most = 4000;
  if (points.size() > most) points = xNeverFalls(points) ? thinnedByStretches(points) : thinnedByDistance(points);
  std::string text;
  for (const Point& point : points) {
    if (!point.isGap()) text += fmt::format("{:.12g} {:.12g}", point.x, point.y);
    text += '\n';
  }
  return text;
}

std::string arrowBlock(const Series& series) {
  std::string text;
  for (std::size_t i = 0; i < series.x.size(); ++i) {
    const double numbers[] = {series.x[i], series.y[i], series.dx[i], series.dy[i]};
    if (!std::all_of(std::begin(numbers), std::end(numbers), [](double n) { return isDrawable(n, false); })) continue;
    text += fmt::format("{:.12g} {:.12g} {:.12g} {:.12g}\n", numbers[0], numbers[1], numbers[2], numbers[3]);
  }
  return text;
}

std::string fieldBlock(const Field& field) {
  std::string text;
  for (std::size_t j = 0; j < field.y.size(); ++j) {
    for (std::size_t i = 0; i < field.x.size(); ++i) {
      const double value = field.values[j * field.x.size() + i];
      text += fmt::format("{:.8g} {:.8g} ", field.x[i], field.y[j]);
      if (isDrawable(value, false)) {
        text += fmt::format("{:.8g}\n", value);
      } else {
        text += "NaN\n";
      }
    }
    text += '\n';
  }
  return text;
}

}  // namespace muelle
