#include "figures/figure_data.h"

#include "figures/data_block.h"
#include "figures/line_styles.h"
#include "figures/ranges.h"

#include <fmt/format.h>
#include <algorithm>

namespace muelle::figures {

std::string Curve::nameInKey() const {
  if (!leaves.empty()) return series->name.empty() ? leaves : series->name + " (" + leaves + ")";
  return block >= 0 || series->name.empty() ? series->name : series->name + " (no data)";
}

const std::string& xLabelOf(const Figure& figure, const Panel& panel) {
  return panel.xLabel.empty() ? figure.xLabel() : panel.xLabel;
}

namespace {

std::vector<const Series*> inKeyOrder(const Panel& panel) {
  std::vector<const Series*> order;
  for (const Series& series : panel.series) order.push_back(&series);
  std::stable_partition(order.begin(), order.end(),
                        [](const Series* s) { return s->pen != Pen::Reference && s->pen != Pen::Structure; });
  return order;
}

bool isDrawnAsPoints(Pen pen, const std::string& lines) {
  if (pen == Pen::Points || pen == Pen::Cells || pen == Pen::Nodes) return true;
  // A line through one point would not be seen.
  const bool isOnePoint = std::count(lines.begin(), lines.end(), '\n') == 1;
  return isOnePoint && (pen == Pen::Line || pen == Pen::Reference);
}

/// A line up to the first point beyond what its panel shows: one that comes back would draw strokes across, and would
/// belie that it has left. Markers draw none, and a reference never leaves.
Series upToItsExit(const Series& series, const Figure& figure, const Panel& panel) {
  Series seen = series;
  if (series.pen != Pen::Line && series.pen != Pen::LinePoints) return seen;
  if (const std::optional<std::size_t> exit = exitOf(series, figure, panel)) {
    seen.x.resize(*exit + 1);
    seen.y.resize(*exit + 1);
  }
  return seen;
}

/// What is said of a curve that goes beyond what its panel shows; empty when it does not. A label "time [s]" makes it
/// "leaves the picture at t = 0.2 s"; along a path there is no time to name.
std::string leavingWords(const Series& series, const Figure& figure, const Panel& panel) {
  if (series.pen == Pen::Reference) return "";
  const std::optional<std::size_t> exit = exitOf(series, figure, panel);
  if (!exit) return "";
  if (figure.hasEqualAxes() || panel.equalAxes) return "leaves the picture";
  const std::string& label = xLabelOf(figure, panel);
  const std::size_t unit = std::min(label.find(" ["), label.size());
  std::string quantity = label.substr(0, unit);
  if (quantity == "time") quantity = "t";
  std::string words = fmt::format("leaves the picture at {} = {:.3g}", quantity, series.x[*exit]);
  if (label.size() > unit + 3) words += ' ' + label.substr(unit + 2, label.size() - unit - 3);
  return words;
}

class DataWriter {
 public:
  explicit DataWriter(const Figure& figure) : figure_(figure) { data_.text = "# " + figure.title() + '\n'; }

  FigureData write() {
    for (const Panel& panel : figure_.panels()) addPanel(panel);
    return std::move(data_);
  }

 private:
  void addPanel(const Panel& panel) {
    PanelCurves drawn;
    if (panel.field) drawn.fieldBlock = addBlock(panel.field->label, fieldBlock(*panel.field));
    int next = 0;  // position in the palette
    for (const Series* series : inKeyOrder(panel)) drawn.curves.push_back(addCurve(*series, panel, next));
    data_.panels.push_back(std::move(drawn));
  }

  Curve addCurve(const Series& series, const Panel& panel, int& next) {
    const bool logX = hasLogX(figure_, panel);
    const std::string lines = series.pen == Pen::Arrows
                                  ? arrowBlock(series)
                                  : dataBlock(upToItsExit(series, figure_, panel), logX, panel.logY);
    const int style = styleOf(series, next);
    const int mark = series.pen == Pen::Cells ? style + cellStyle : style;
    const std::string leaves = leavingWords(series, figure_, panel);
    const std::string name = fmt::format("{}; columns: {}, {}", series.name, xLabelOf(figure_, panel), panel.yLabel);
    const int block = lines.empty() ? -1 : addBlock(name, lines);
    return {&series, block, isDrawnAsPoints(series.pen, lines), style, mark, leaves};
  }

  int styleOf(const Series& series, int& next) {
    if (series.pen == Pen::Reference) return referenceStyle;
    if (series.pen == Pen::Structure) return structureStyle;
    if (series.pen == Pen::Nodes) return nodeStyle;
    const int position = series.colour >= 0 ? series.colour : next++;
    data_.styleCount = std::max(data_.styleCount, std::min(position + 1, mostLineStyles));
    return 1 + position % mostLineStyles + (series.pen == Pen::Mesh ? meshStyle : 0);
  }

  /// The index of the block.
  int addBlock(const std::string& name, const std::string& lines) {
    data_.text += fmt::format("{}# block {}: {}\n{}", blocks_ > 0 ? "\n\n" : "", blocks_, name, lines);
    return blocks_++;
  }

  const Figure& figure_;
  FigureData data_;
  int blocks_ = 0;
};

}  // namespace

FigureData figureData(const Figure& figure) { return DataWriter(figure).write(); }

}  // namespace muelle::figures
