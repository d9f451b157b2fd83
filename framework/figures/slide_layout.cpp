#include "figures/slide_layout.h"

#include "figures/key_layout.h"
#include "figures/measures.h"
#include "figures/plot_box.h"

#include <algorithm>

namespace muelle::figures {

namespace {

constexpr double slideHeight = 540;  // 16 : 9
constexpr double nameHeight = 15;    // of a row of a table: its name, 13 px, and the gap to the next
constexpr double columnGap = 26;
constexpr double slideIndent = 24;  // the least room left of a y label
constexpr double headingHeight = 26;
constexpr double headingGap = 10;   // between a heading and the y label beside it
constexpr double labelRise = 14;    // the x label stands so far above the foot's end
constexpr double colourRoom = 92;   // a field's colour scale, its numbers and its label
constexpr double colourGap = 12;    // between a field and its colour scale
constexpr double colourWidth = 14;  // of the scale itself

/// The label of a field's colours stands right of the key.
double besideKey(const PanelShape& shape) { return shape.colours ? *shape.colours + entryGap : 0.0; }

double colourRoomOf(const PanelShape& shape) { return shape.colours ? colourRoom : 0.0; }

/// Room left of a plot, for the numbers or names of the y axis. \param height of the plot, about
double leftMarginOf(const AxisShape& y, double height) {
  if (y.names) return std::max(plotLeft, 20 + *y.names);
  const double widest = y.logarithmic ? textWidth(5) : textWidth(widestNumber(y.range, yStepOf(y, y.range, height)));
  return std::clamp(34 + widest, 64.0, 1.5 * plotLeft);
}

/// So far left of its plot, over the numbers of its axis, begins the y label.
double indentOfLabel(double leftMargin) { return std::min(labelIndent, leftMargin - slideIndent); }

/// A panel of a slide while it is placed.
struct Draft {
  const PanelShape& shape;
  double leftMargin;
  KeyRows key;
  bool headingBesideLabel;  ///< both in one row

  /// Height of what stands above the plot.
  double header() const {
    return rowHeight * static_cast<double>(key.size()) + headerFoot +
           (shape.heading == 0 || headingBesideLabel ? 0.0 : headingHeight);
  }
};

/// The heights that the plots of a row have in common.
struct Row {
  double header = 0;
  double foot = 0;
};

class SlideLayout {
 public:
  explicit SlideLayout(const FigureShape& figure)
      : columns_(static_cast<std::size_t>(figure.columns)),
        rows_(std::max<std::size_t>(1, (figure.panels.size() + columns_ - 1) / columns_)),
        columnWidth_((plotRight - columnGap * (figure.columns - 1)) / figure.columns) {
    for (const PanelShape& shape : figure.panels) include(shape);
    plotHeight_ = slideHeight - titleHeight;
    for (const Row& row : rows_) plotHeight_ -= row.header + row.foot;
    plotHeight_ /= static_cast<double>(rows_.size());
    makeRoomForNames();
  }

  Layout layout() const {
    Layout layout;
    layout.height = height_;
    double top = titleHeight;
    for (std::size_t i = 0; i < drafts_.size(); ++i) {
      const Row& row = rows_[i / columns_];
      layout.panels.push_back(place(drafts_[i], columnLeft(i), top + row.header, row.header));
      if (i % columns_ + 1 == columns_) top = top + row.header + plotHeight_ + row.foot;
    }
    return layout;
  }

 private:
  double columnLeft(std::size_t panel) const {
    return static_cast<double>(panel % columns_) * (columnWidth_ + columnGap);
  }

  /// A table that is a slide's only panel, and has more rows than a slide has room for, makes it taller: its names
  /// would stand in one another.
  void makeRoomForNames() {
    if (drafts_.size() != 1) return;
    const double wanted = std::max(plotHeight_, nameHeight * static_cast<double>(drafts_[0].shape.y.rows));
    height_ += wanted - plotHeight_;
    plotHeight_ = wanted;
  }

  void include(const PanelShape& shape) {
    constexpr double aroundPlot = 130;
    const double height = slideHeight / static_cast<double>(rows_.size()) - aroundPlot;
    const double leftMargin = leftMarginOf(shape.y, height);
    const double room = columnWidth_ - leftMargin + indentOfLabel(leftMargin);  // from the y label's beginning
    Draft draft{shape, leftMargin, keyRows(shape, room - besideKey(shape)), false};
    draft.headingBesideLabel = fitsBesideLabel(draft);
    Row& row = rows_[drafts_.size() / columns_];
    row.header = std::max(row.header, draft.header());
    row.foot = std::max(row.foot, footOf(shape));
    drafts_.push_back(std::move(draft));
  }

  /// Whether the heading, over the middle of the plot, leaves room for the y label at the column's beginning.
  bool fitsBesideLabel(const Draft& draft) const {
    const PanelShape& shape = draft.shape;
    if (shape.heading == 0 || shape.colours || draft.key.size() > 1 || !draft.key.front().empty()) return false;
    const double middle = 0.5 * (draft.leftMargin + columnWidth_);
    return middle - 0.5 * shape.heading > slideIndent + shape.yLabel + headingGap;
  }

  PanelLayout place(Draft draft, double left, double plotTop, double rowHeader) const {
    const PanelShape& shape = draft.shape;
    PanelLayout panel;
    panel.plot = {left + draft.leftMargin, left + columnWidth_ - colourRoomOf(shape), plotTop, plotTop + plotHeight_};
    panel.x = shape.x.range;
    panel.y = shape.y.range;
    if (shape.equalAxes) equaliseAxes(panel, shape.colours.has_value(), 0);
    // What equal axes have made lower keeps its heading near.
    const double header = panel.plot.top > plotTop + 1 ? draft.header() : rowHeader;
    // Where the neighbours need two lines, so has this one.
    if (header > draft.header()) draft.headingBesideLabel = false;
    placeHeader(labelLeft(draft, panel.plot), panel.plot.right + colourRoomOf(shape) - besideKey(shape), shape,
                draft.key, panel);
    if (shape.heading > 0) placeHeading(shape.heading, left, panel.plot.top - header, panel);
    placeAxes(shape, panel);
    if (shape.colours) placeColours(*shape.colours, panel);
    return panel;
  }

  /// Over the numbers of the y axis, further left where the heading would touch it.
  static double labelLeft(const Draft& draft, const Box& plot) {
    const double overNumbers = plot.left - indentOfLabel(draft.leftMargin);
    if (!draft.headingBesideLabel) return overNumbers;
    const double heading = 0.5 * (plot.left + plot.right) - 0.5 * draft.shape.heading;
    return std::min(overNumbers, heading - headingGap - draft.shape.yLabel);
  }

  /// Over the plot, on one line with the others of its row; moved aside and made smaller to stay in its column.
  void placeHeading(double width, double left, double top, PanelLayout& panel) const {
    panel.headingSize = std::clamp(headingFont * columnWidth_ / width, 11.0, headingFont);
    const double taken = std::min(width * panel.headingSize / headingFont, columnWidth_ - 1);
    const double middle =
        std::clamp(0.5 * (panel.plot.left + panel.plot.right), left + 0.5 * taken, left + columnWidth_ - 0.5 * taken);
    panel.heading = Label{middle, top + 0.5 * rowHeight, taken, Side::Centre};
  }

  static void placeAxes(const PanelShape& shape, PanelLayout& panel) {
    if (shape.xLabel) panel.xLabel = xLabelBelow(panel.plot, footOf(shape) - labelRise, *shape.xLabel);
    panel.xStep = xStepOf(shape.x, panel.x, panel.plot.width());
    panel.yStep = yStepOf(shape.y, panel.y, panel.plot.height());
    panel.turnsXNames = shape.x.names.value_or(0.0) > widestLevelName();
  }

  static void placeColours(double label, PanelLayout& panel) {
    const Box& plot = panel.plot;
    panel.colourScale = Box{plot.right + colourGap, plot.right + colourGap + colourWidth, plot.top, plot.bottom};
    panel.colourLabel = {plot.right + colourRoom, plot.top - headerFoot - 0.5 * rowHeight, label, Side::Right};
  }

  std::size_t columns_;
  std::vector<Row> rows_;
  double columnWidth_;
  double height_ = slideHeight;
  double plotHeight_ = 0;
  std::vector<Draft> drafts_;
};

}  // namespace

Layout slideLayout(const FigureShape& figure) { return SlideLayout(figure).layout(); }

}  // namespace muelle::figures
