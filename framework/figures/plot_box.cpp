#include "figures/plot_box.h"

#include "figures/measures.h"

#include <algorithm>
#include <cmath>

namespace muelle::figures {

void equaliseAxes(PanelLayout& panel, bool isField, double slimmest) {
  Box& plot = panel.plot;
  const double width = plot.width();
  const double height = plot.height();
  const double scale = std::max(panel.x.span() / width, panel.y.span() / height);  // per pixel
  if (isField) {
    plot.right = plot.left + panel.x.span() / scale;
    plot.top = plot.bottom - panel.y.span() / scale;
    return;
  }
  panel.y = widened(panel.y, scale * height);
  const double plotWidth = std::clamp(panel.x.span() / scale, slimmest, width);
  panel.x = widened(panel.x, scale * plotWidth);
  plot.left += 0.5 * (width - plotWidth);
  plot.right = plot.left + plotWidth;
}

double widestLevelName() { return textWidth(4, nameCharacter); }

double footOf(const PanelShape& shape) {
  constexpr double withLabel = 66, numbersAlone = 40;
  const double names = shape.x.names.value_or(0.0);
  constexpr double rise = 0.8;    // of a turned name, for its length
  constexpr double numbers = 20;  // which the names replace
  return (shape.xLabel ? withLabel : numbersAlone) + (names > widestLevelName() ? names * rise - numbers : 0.0);
}

Label xLabelBelow(const Box& plot, double distance, double width) {
  return {0.5 * (plot.left + plot.right), plot.bottom + distance, width, Side::Centre};
}

namespace {

/// The factor between the numbers of a logarithmic axis.
double logStep(const AxisRange& range, double length, double pitch) {
  const double decades = std::log10(range.high / range.low);
  return std::pow(10.0, std::max(1.0, std::ceil(decades * pitch / length)));
}

}  // namespace

double yStepOf(const AxisShape& axis, const AxisRange& range, double height) {
  if (axis.logarithmic) return logStep(range, height, 32);
  return ticStep(range, height, std::max(28.0, height / 9));
}

double xStepOf(const AxisShape& axis, const AxisRange& range, double width) {
  if (axis.logarithmic) return logStep(range, width, 56);
  constexpr double apart = 16;
  double step = range.span();
  for (double pitch = std::max(30.0, 0.1 * width); pitch < width; pitch += 10) {
    step = ticStep(range, width, pitch);
    if (textWidth(widestNumber(range, step)) + apart <= width * step / range.span()) break;
  }
  return step;
}

}  // namespace muelle::figures
