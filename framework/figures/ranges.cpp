#include "figures/ranges.h"

#include <algorithm>

namespace muelle::figures {

bool hasLogX(const Figure& figure, const Panel& panel) { return figure.hasLogX() || panel.logX; }

namespace {

// Parts of the span that stay free on each side of an axis.
constexpr double marginOfPoints = 0.04;  // markers would stand half outside
constexpr double marginOfHeights = 0.06;

bool anyPoints(const Panel& panel) {
  return std::any_of(panel.series.begin(), panel.series.end(), [](const Series& s) {
    return s.pen == Pen::Points || s.pen == Pen::LinePoints || s.pen == Pen::Arrows || s.pen == Pen::Cells ||
           s.pen == Pen::Nodes;
  });
}

/// What an axis may show where right answers reach `expected`: three times that.
std::optional<AxisRange> allowed(const FixedRange& expected, bool logarithmic) {
  if (!expected || logarithmic) return std::nullopt;
  const AxisRange range{expected->first, expected->second};
  return widened(range, 3.0 * range.span());
}

AxisRange cutTo(const std::optional<AxisRange>& most, AxisRange range) {
  if (!most) return range;
  const AxisRange both{std::max(range.low, most->low), std::min(range.high, most->high)};
  return both.low < both.high ? both : *most;
}

AxisRange fixedOr(const FixedRange& fixed, AxisRange range) {
  return fixed ? AxisRange{fixed->first, fixed->second} : range;
}

/// Calls visit(x, y) for what the panel's curves reach: points, corners of cells, feet and tips of arrows.
template <class Visit>
void forEachPoint(const Figure& figure, const Panel& panel, Visit visit) {
  for (const Series& series : panel.series) {
    const double half = series.pen == Pen::Cells ? 0.5 : 0.0;
    for (std::size_t i = 0; i < series.x.size(); ++i) {
      const double x = series.x[i], y = series.y[i];
      if (!isDrawable(x, hasLogX(figure, panel)) || !isDrawable(y, panel.logY)) continue;
      for (const double side : {-half, half}) visit(x + side, y + side);
      if (series.pen == Pen::Arrows) visit(x + series.dx[i], y + series.dy[i]);
    }
  }
}

/// The x axis that stacked panels share.
AxisRange sharedX(const Figure& figure) {
  bool points = figure.hasEqualAxes();
  AxisFitter xs(figure.hasLogX());
  for (const Panel& panel : figure.panels()) {
    points = points || anyPoints(panel);
    forEachPoint(figure, panel, [&xs](double x, double) { xs.include(x); });
  }
  AxisRange range = xs.range(points ? marginOfPoints : 0.0);
  for (const Panel& panel : figure.panels()) range = cutTo(allowed(panel.xExpected, figure.hasLogX()), range);
  return range;
}

PanelRanges ownRanges(const Figure& figure, const Panel& panel) {
  AxisFitter xs(hasLogX(figure, panel));
  AxisFitter ys(panel.logY);
  const auto include = [&](double x, double y) {
    xs.include(x);
    ys.include(y);
  };
  if (const auto& field = panel.field) {
    include(field->x.front(), field->y.front());
    include(field->x.back(), field->y.back());
  }
  forEachPoint(figure, panel, include);
  const bool isTable = !panel.yNames.empty() || panel.field.has_value();
  const bool hasMargin = !isTable && (anyPoints(panel) || panel.equalAxes);
  const AxisRange x =
      cutTo(allowed(panel.xExpected, hasLogX(figure, panel)), xs.range(hasMargin ? marginOfPoints : 0.0));
  const AxisRange y = cutTo(allowed(panel.yExpected, panel.logY), ys.range(isTable ? 0.0 : marginOfHeights));
  return {fixedOr(panel.xRange, x), fixedOr(panel.yRange, y)};
}

}  // namespace

std::optional<std::size_t> exitOf(const Series& series, const Figure& figure, const Panel& panel) {
  const std::optional<AxisRange> x = allowed(panel.xExpected, hasLogX(figure, panel));
  const std::optional<AxisRange> y = allowed(panel.yExpected, panel.logY);
  const auto isBeyond = [](const std::optional<AxisRange>& most, double value) {
    return most && (value < most->low || value > most->high);
  };
  for (std::size_t i = 0; i < series.x.size(); ++i) {
    if (isBeyond(x, series.x[i]) || isBeyond(y, series.y[i])) return i;
  }
  return std::nullopt;
}

std::vector<PanelRanges> rangesOf(const Figure& figure) {
  std::vector<PanelRanges> ranges;
  for (const Panel& panel : figure.panels()) ranges.push_back(ownRanges(figure, panel));
  if (figure.isSlide()) return ranges;
  const AxisRange shared = sharedX(figure);
  for (PanelRanges& panel : ranges) panel.x = shared;
  return ranges;
}

}  // namespace muelle::figures
