#include "figures/shape.h"

#include "base/text/utf8.h"
#include "figures/measures.h"
#include "figures/ranges.h"

#include <algorithm>

namespace muelle::figures {

namespace {

/// Width of a text in characters of a given width.
double widthOf(std::string_view text, double character = characterWidth) {
  return textWidth(static_cast<std::size_t>(muelle::columns(text)), character);
}

std::optional<double> widestOf(const std::vector<std::string>& names) {
  if (names.empty()) return std::nullopt;
  double widest = 0;
  for (const std::string& name : names) widest = std::max(widest, widthOf(name, nameCharacter));
  return widest;
}

std::vector<double> keyOf(const PanelCurves& drawn) {
  std::vector<double> widths;
  for (const Curve& curve : drawn.curves) {
    const std::string name = curve.nameInKey();
    if (!name.empty()) widths.push_back(sampleLength + sampleGap + widthOf(name));
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
  shape.x = {ranges.x, hasLogX(figure, panel), widestOf(panel.xNames), panel.xNames.size()};
  shape.y = {ranges.y, panel.logY, widestOf(panel.yNames), panel.yNames.size()};
  shape.equalAxes = figure.hasEqualAxes() || (figure.isSlide() && panel.equalAxes);
  shape.yLabel = widthOf(panel.yLabel);
  shape.heading = widthOf(panel.heading, headingCharacter);
  shape.key = keyOf(drawn);
  if (panel.field) shape.colours = widthOf(panel.field->label);
  return shape;
}

}  // namespace

FigureShape shapeOf(const Figure& figure, const FigureData& data) {
  FigureShape shape;
  shape.columns = figure.columns();
  shape.title = widthOf(figure.title() + " ", titleCharacter);
  const std::vector<PanelRanges> ranges = rangesOf(figure);
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    const Panel& panel = figure.panels()[i];
    shape.panels.push_back(shapeOf(figure, panel, data.panels[i], ranges[i]));
    if (standsXLabel(figure, i)) shape.panels.back().xLabel = widthOf(xLabelOf(figure, panel));
  }
  return shape;
}

}  // namespace muelle::figures
