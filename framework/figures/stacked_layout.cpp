#include "figures/stacked_layout.h"

#include "figures/key_layout.h"
#include "figures/measures.h"
#include "figures/plot_box.h"

#include <algorithm>

namespace muelle::figures {

namespace {

constexpr double panelGap = 16;
constexpr double footHeight = 72;       // numbers and label of the x axis
constexpr double sharedLabelRise = 12;  // the x label stands so far above the foot's end
constexpr double singleHeight = 386;
constexpr double stackedHeight = 196;
constexpr double equalHeight = 500;
constexpr double slimmest = 360;  // width of a plot with equal axes

double plotHeightOf(const FigureShape& figure) {
  if (figure.panels.size() != 1) return stackedHeight;
  return figure.panels.front().equalAxes ? equalHeight : singleHeight;
}

/// Where the plots begin: as far right as the longest number of their y axes needs, its sign included.
double leftOf(const FigureShape& figure, double plotHeight) {
  constexpr double beside = 34;     // the tic, and what keeps a number off the canvas's edge
  constexpr double furthest = 300;  // for ranges without any sense
  double left = plotLeft;
  for (const PanelShape& shape : figure.panels) {
    if (shape.y.logarithmic) continue;
    const double step = yStepOf(shape.y, shape.y.range, plotHeight);
    left = std::max(left, beside + textWidth(widestNumber(shape.y.range, step)));
  }
  return std::min(left, furthest);
}

/// \param top of the panel: of the row of its y label
PanelLayout panelAt(double top, double left, const PanelShape& shape, double plotHeight) {
  const KeyRows key = keyRows(shape, plotRight - left + labelIndent);
  const double plotTop = top + (rowHeight * static_cast<double>(key.size()) + headerFoot);
  PanelLayout panel;
  panel.plot = {left, plotRight, plotTop, plotTop + plotHeight};
  panel.x = shape.x.range;
  panel.y = shape.y.range;
  if (shape.equalAxes) equaliseAxes(panel, shape.colours.has_value(), slimmest);
  placeHeader(panel.plot.left - labelIndent, plotRight, shape, key, panel);
  if (shape.xLabel) panel.xLabel = xLabelBelow(panel.plot, footOf(shape) - sharedLabelRise, *shape.xLabel);
  return panel;
}

}  // namespace

Layout stackedLayout(const FigureShape& figure) {
  const double plotHeight = plotHeightOf(figure);
  const double left = leftOf(figure, plotHeight);
  Layout layout;
  double top = titleHeight;
  for (const PanelShape& shape : figure.panels) {
    layout.panels.push_back(panelAt(top, left, shape, plotHeight));
    top = layout.panels.back().plot.bottom + panelGap;
  }
  layout.height = top - panelGap + footHeight;
  return layout;
}

}  // namespace muelle::figures
