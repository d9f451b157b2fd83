#include "figures/shape.h"

#include "figures/measures.h"
#include "figures/ranges.h"

#include <algorithm>

namespace muelle::figures {

namespace {

std::optional<double> widestOf(const std::vector<std::string>& names) {
  if (names.empty()) return std::nullopt;
  std::size_t longest = 0;
  for (const std::string& name : names) longest = std::max(longest, name.size());
  return textWidth(longest, nameCharacter);
}

std::vector<double> keyOf(const PanelCurves& drawn) {
  std::vector<double> widths;
  for (const Curve& curve : drawn.curves) {
    if (curve.series->name.empty()) continue;
    widths.push_back(sampleLength + sampleGap + textWidth(curve.nameInKey().size()));
  }
  return widths;
}

/// Whether the x label of a panel stands: not where the panel below it has the same.
bool standsXLabel(const Figure& figure, std::size_t index) {
  const std::vector<Panel>& panels = figure.panels();
  const std::size_t below = index + (figure.isSlide() ? static_cast<std::size_t>(figure.columns()) : 1);
  if (below >= panels.size()) return true;
  return figure.isSlide() && xLabelOf(figure, panels[index]) != xLabelOf(figure, panels[below]);
}

PanelShape shapeOf(const Figure& figure, const Panel& panel, const PanelCurves& drawn, const PanelRanges& ranges) {
  PanelShape shape;
  shape.x = {ranges.x, hasLogX(figure, panel), widestOf(panel.xNames)};
  shape.y = {ranges.y, panel.logY, widestOf(panel.yNames)};
  shape.equalAxes = figure.hasEqualAxes() || (figure.isSlide() && panel.equalAxes);
  shape.yLabel = textWidth(panel.yLabel.size());
  shape.heading = textWidth(panel.heading.size(), headingCharacter);
  shape.key = keyOf(drawn);
  if (panel.field) shape.colours = textWidth(panel.field->label.size());
  return shape;
}

}  // namespace

FigureShape shapeOf(const Figure& figure, const FigureData& data) {
  FigureShape shape;
  shape.columns = figure.columns();
  shape.title = textWidth(figure.title().size() + 1, titleCharacter);
  const std::vector<PanelRanges> ranges = rangesOf(figure);
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    const Panel& panel = figure.panels()[i];
    shape.panels.push_back(shapeOf(figure, panel, data.panels[i], ranges[i]));
    if (standsXLabel(figure, i)) shape.panels.back().xLabel = textWidth(xLabelOf(figure, panel).size());
  }
  return shape;
}

}  // namespace muelle::figures
