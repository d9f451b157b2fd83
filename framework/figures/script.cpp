#include "figures/script.h"

#include "figures/axis.h"
#include "figures/data_block.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <initializer_list>

namespace muelle {

namespace {

// The layout in pixels of a 960 wide canvas, which a slide shows at about twice the size.
constexpr double canvasWidth = 960;
constexpr double plotLeft = 112;  // room for the numbers on the y axis
constexpr double plotRight = 926;
constexpr double labelIndent = 88;  // the y label begins so far left of the plot, above the numbers
constexpr double titleHeight = 50;
constexpr double rowHeight = 26;   // a row above a panel: the y label and the key
constexpr double headerFoot = 12;  // between those rows and the plot, for the topmost number of the y axis
constexpr double panelGap = 16;
constexpr double footHeight = 72;  // numbers and label of the x axis
constexpr double singleHeight = 386;
constexpr double stackedHeight = 196;
constexpr double equalHeight = 500;
constexpr double slideHeight = 540;       // 16 : 9
constexpr double slideFoot = 66;          // numbers and label of an x axis
constexpr double numbersFoot = 40;        // numbers alone
constexpr double slideIndent = 24;        // the y label begins so far right of its column's beginning
constexpr double headingCharacter = 9.8;  // width in a heading of 18 px
constexpr double headingHeight = 26;
constexpr double columnGap = 26;
constexpr double colourScale = 92;           // room for a field's colour scale, its numbers and its label
constexpr double nameWidth = 7.4;            // of a character of the names along an axis
constexpr double scaleOfSlides = 4.0 / 3.0;  // 1280 pixels for 960
constexpr double characterWidth = 10.0;      // of the 17 px font, on the generous side: the viewer chooses the face
constexpr double sampleLength = 40;          // the piece of line before a name in the key
constexpr double sampleGap = 8;
constexpr double entryGap = 20;

/// gnuplot's measure: fractions of the canvas, y from the bottom.
class Canvas {
 public:
  explicit Canvas(double height) : height_(height) {}
  double height() const { return height_; }
  std::string x(double pixels) const { return fmt::format("{:.5f}", pixels / canvasWidth); }
  std::string y(double pixelsFromTop) const { return fmt::format("{:.5f}", 1.0 - pixelsFromTop / height_); }

 private:
  double height_;
};

void replaceAll(std::string& text, std::string_view what, std::string_view with) {
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + with.size())) {
    text.replace(at, what.size(), with);
  }
}

/// A gnuplot string that holds plain text. The apostrophe, the only plain character with a meaning there, becomes the
/// typographic one.
std::string quoted(std::string text) {
  replaceAll(text, "'", "\u2019");
  replaceAll(text, "^2", "\u00b2");
  replaceAll(text, "^3", "\u00b3");
  replaceAll(text, "->", "\u2192");
  return '\'' + text + '\'';
}

double widthOf(const std::string& text) { return characterWidth * static_cast<double>(text.size()); }

/// A curve as the script knows it.
struct Curve {
  const Series* series;
  int block;  ///< index in the data file; -1: no point to draw
  bool asPoints;
  int style;      ///< number of the line style
  int markStyle;  ///< of the mark in the key: a square for cells

  std::string nameInKey() const {
    return block >= 0 || series->name.empty() ? series->name : series->name + " (no data)";
  }
  double widthInKey() const { return sampleLength + sampleGap + widthOf(nameInKey()); }
};

/// The curves that have a name, in rows from the top. The first row shares its line with the y label and may be empty.
using KeyRows = std::vector<std::vector<Curve>>;

/// \param width from the y label's beginning to the plot's right end
KeyRows keyRows(const std::vector<Curve>& curves, const std::string& yLabel, double width) {
  KeyRows rows(1);
  double room = width - widthOf(yLabel) - entryGap;
  for (const Curve& curve : curves) {
    if (curve.series->name.empty()) continue;
    const double entry = curve.widthInKey() + entryGap;
    const bool isAlone = rows.size() > 1 && rows.back().empty();
    if (entry > room && !isAlone) {
      rows.emplace_back();
      room = width - labelIndent;
    }
    room -= entry;
    rows.back().push_back(curve);
  }
  return rows;
}

/// Where a panel lies: pixels from the top left corner.
struct Box {
  double left, right, top, bottom;
};

struct PanelPlan {
  const Panel* panel;
  std::vector<Curve> curves;
  KeyRows key;
  AxisRange x, y;
  Box box;
  int fieldBlock = -1;              ///< index of the field in the data file
  double leftMargin = plotLeft;     ///< room for the numbers or names of the y axis
  double labelLeft = 0;             ///< where the y label begins
  bool hasXLabel = true;            ///< of a slide's panel: no when the one below has the same
  bool headingBesideLabel = false;  ///< both in one row
  double header = 0;                ///< height of what stands above a slide's plots, the highest of its row
  double columnLeft = 0;            ///< of a slide
};

bool anyPoints(const Panel& panel) {
  return std::any_of(panel.series.begin(), panel.series.end(),
                     [](const Series& s) { return s.pen != Pen::Line && s.pen != Pen::Reference; });
}

/// Distance of the numbers on the y axis of a slide: not too close, nor too many.
double yTicStep(const AxisRange& range, double height) { return ticStep(range, height, std::max(28.0, height / 9)); }

/// Room left of a slide's plot, for the numbers or names of the y axis. \param height of the plot, about
double leftMarginOf(const Panel& panel, const AxisRange& y, double height) {
  if (panel.yNames.empty()) {
    const double widest = panel.logY ? 5.0 : static_cast<double>(widestNumber(y, yTicStep(y, height)));
    return std::clamp(34 + characterWidth * widest, 64.0, plotLeft);
  }
  double widest = 0;
  for (const std::string& name : panel.yNames) widest = std::max(widest, static_cast<double>(name.size()));
  return std::max(plotLeft, 20 + nameWidth * widest);
}

/// Distance of the numbers on the x axis of a slide: as close as they stay apart.
double xTicStep(const AxisRange& range, double width) {
  double step = range.span();
  for (double pitch = std::max(30.0, 0.1 * width); pitch < width; pitch += 10) {
    step = ticStep(range, width, pitch);
    if (characterWidth * static_cast<double>(widestNumber(range, step)) + 16 <= width * step / range.span()) break;
  }
  return step;
}

/// The same on a logarithmic axis: the factor between numbers.
double logTicFactor(const AxisRange& range, double length, double pitch) {
  const double decades = std::log10(range.high / range.low);
  return std::pow(10.0, std::max(1.0, std::ceil(decades * pitch / length)));
}

/// The curves in the order in which the key names them: the simulated ones first.
std::vector<const Series*> inKeyOrder(const Panel& panel) {
  std::vector<const Series*> order;
  for (const Series& series : panel.series) order.push_back(&series);
  std::stable_partition(order.begin(), order.end(), [](const Series* s) { return s->pen != Pen::Reference; });
  return order;
}

class ScriptWriter {
 public:
  ScriptWriter(const Figure& figure, Format format) : figure_(figure), format_(format), canvas_(0) {
    planPanels();
    figure.isSlide() ? placeOnSlide() : placePanels();
  }

  FigureText write() {
    writeHead();
    for (std::size_t i = 0; i < plans_.size(); ++i) writePanel(plans_[i], i == 0, i + 1 == plans_.size());
    script_ += "unset multiplot\nunset output\n";
    return {std::move(data_), std::move(script_)};
  }

 private:
  template <class... Args>
  void put(fmt::format_string<Args...> text, Args&&... args) {
    script_ += fmt::format(text, std::forward<Args>(args)...) + '\n';
  }

  void planPanels() {
    AxisFitter shared(figure_.hasLogX());
    bool points = figure_.hasEqualAxes();
    data_ = "# " + figure_.title() + '\n';
    for (const Panel& panel : figure_.panels()) {
      points = points || anyPoints(panel);
      PanelPlan plan{&panel, {}, {}, {}, {}, {}};
      AxisFitter own(logX(panel));
      AxisFitter ys(panel.logY);
      if (panel.field) addField(*panel.field, plan, own, ys);
      int colour = 0;
      for (const Series* series : inKeyOrder(panel)) {
        addBlock(*series, panel, plan, colour);
        for (std::size_t i = 0; i < series->x.size(); ++i) includePoint(*series, i, panel, {&own, &shared}, ys);
      }
      const bool isTable = !panel.yNames.empty() || panel.field.has_value();
      const double margin = !isTable && (anyPoints(panel) || panel.equalAxes) ? 0.04 : 0.0;
      plan.x = fixedOr(panel.xRange, own.range(margin));
      plan.y = fixedOr(panel.yRange, ys.range(isTable ? 0.0 : 0.06));
      plans_.push_back(std::move(plan));
    }
    for (PanelPlan& plan : plans_) {
      if (!figure_.isSlide()) plan.x = shared.range(points ? 0.04 : 0.0);
      double width = plotRight - plotLeft + labelIndent;
      if (figure_.isSlide()) {
        plan.leftMargin = leftMarginOf(*plan.panel, plan.y, slideHeight / static_cast<double>(rowsOfSlide()) - 130);
        width = columnWidth() - slideIndent - besideKey(*plan.panel);
      }
      plan.key = keyRows(plan.curves, plan.panel->yLabel, width);
    }
  }

  bool logX(const Panel& panel) const { return figure_.hasLogX() || panel.logX; }
  static AxisRange fixedOr(const FixedRange& fixed, AxisRange range) {
    return fixed ? AxisRange{fixed->first, fixed->second} : range;
  }

  void includePoint(const Series& series, std::size_t i, const Panel& panel, std::initializer_list<AxisFitter*> xs,
                    AxisFitter& ys) {
    if (!isDrawable(series.x[i], logX(panel)) || !isDrawable(series.y[i], panel.logY)) return;
    const double half = series.pen == Pen::Cells ? 0.5 : 0.0;
    for (const double side : {-half, half}) {
      for (AxisFitter* x : xs) x->include(series.x[i] + side);
      ys.include(series.y[i] + side);
    }
    if (series.pen != Pen::Arrows) return;
    for (AxisFitter* x : xs) x->include(series.x[i] + series.dx[i]);
    ys.include(series.y[i] + series.dy[i]);
  }

  /// Where the next block of the data file stands.
  std::string separator() const { return blocks_ > 0 ? "\n\n" : ""; }

  void addField(const Field& field, PanelPlan& plan, AxisFitter& xs, AxisFitter& ys) {
    for (const double x : {field.x.front(), field.x.back()}) xs.include(x);
    for (const double y : {field.y.front(), field.y.back()}) ys.include(y);
    data_ += fmt::format("{}# block {}: {}\n{}", separator(), blocks_, field.label, fieldBlock(field));
    plan.fieldBlock = blocks_++;
  }

  void addBlock(const Series& series, const Panel& panel, PanelPlan& plan, int& colour) {
    const std::string lines =
        series.pen == Pen::Arrows ? arrowBlock(series) : dataBlock(series, logX(panel), panel.logY);
    // A line through one point would not be seen.
    const bool isOnePoint = std::count(lines.begin(), lines.end(), '\n') == 1;
    const bool isReference = series.pen == Pen::Reference;
    const int position = series.colour >= 0 || isReference ? series.colour : colour++;
    const int style = isReference ? referenceStyle : 1 + position % mostStyles;
    styleCount_ = std::max(styleCount_, std::min(position + 1, mostStyles));
    const bool asPoints = series.pen == Pen::Points || series.pen == Pen::Cells ||
                          (isOnePoint && (series.pen == Pen::Line || series.pen == Pen::Reference));
    const int mark = series.pen == Pen::Cells ? style + cellStyle : style;
    plan.curves.push_back({&series, lines.empty() ? -1 : blocks_, asPoints, style, mark});
    if (lines.empty()) return;
    data_ += fmt::format("{}# block {}: {}; columns: {}, {}\n{}", separator(), blocks_, series.name, xLabelOf(panel),
                         panel.yLabel, lines);
    ++blocks_;
  }

  const std::string& xLabelOf(const Panel& panel) const {
    return panel.xLabel.empty() ? figure_.xLabel() : panel.xLabel;
  }

  void placePanels() {
    double plotHeight = plans_.size() == 1 ? singleHeight : stackedHeight;
    if (figure_.hasEqualAxes() && plans_.size() == 1) plotHeight = equalHeight;
    double y = titleHeight;
    for (PanelPlan& plan : plans_) {
      y += rowHeight * static_cast<double>(plan.key.size()) + headerFoot;
      plan.box = {plotLeft, plotRight, y, y + plotHeight};
      if (figure_.hasEqualAxes()) equaliseAxes(plan, 360);
      plan.labelLeft = plan.box.left - labelIndent;
      y += plotHeight + panelGap;
    }
    canvas_ = Canvas(y - panelGap + footHeight);
  }

  double columnWidth() const {
    return (canvasWidth - (canvasWidth - plotRight) - columnGap * (figure_.columns() - 1)) / figure_.columns();
  }

  std::size_t rowsOfSlide() const {
    const auto columns = static_cast<std::size_t>(figure_.columns());
    return std::max<std::size_t>(1, (figure_.panels().size() + columns - 1) / columns);
  }

  /// The label of a field's colours stands right of the key.
  static double besideKey(const Panel& panel) { return panel.field ? widthOf(panel.field->label) + entryGap : 0.0; }

  /// Rows of plots of equal height; in a row, what stands above and below the plots is as high as the highest needs.
  void placeOnSlide() {
    const auto columns = static_cast<std::size_t>(figure_.columns());
    const std::size_t rows = rowsOfSlide();
    std::vector<double> headers(rows, 0.0), feet(rows, 0.0);
    double plotHeight = slideHeight - titleHeight;
    for (std::size_t i = 0; i < plans_.size(); ++i) {
      plans_[i].hasXLabel =
          i + columns >= plans_.size() || xLabelOf(*plans_[i].panel) != xLabelOf(*plans_[i + columns].panel);
      plans_[i].headingBesideLabel = fitsBesideLabel(plans_[i]);
      headers[i / columns] = std::max(headers[i / columns], headerOf(plans_[i]));
      feet[i / columns] = std::max(feet[i / columns], footOf(plans_[i]));
    }
    for (std::size_t row = 0; row < rows; ++row) plotHeight -= headers[row] + feet[row];
    plotHeight /= static_cast<double>(rows);
    double top = titleHeight;
    for (std::size_t i = 0; i < plans_.size(); ++i) {
      const double left = static_cast<double>(i % columns) * (columnWidth() + columnGap);
      const double right = left + columnWidth() - (plans_[i].panel->field ? colourScale : 0.0);
      const double plotTop = top + headers[i / columns];
      plans_[i].box = {left + plans_[i].leftMargin, right, plotTop, plotTop + plotHeight};
      if (figure_.hasEqualAxes() || plans_[i].panel->equalAxes) equaliseAxes(plans_[i], 0);
      // What equal axes have made lower keeps its heading near.
      plans_[i].header = plans_[i].box.top > plotTop + 1 ? headerOf(plans_[i]) : headers[i / columns];
      plans_[i].columnLeft = left;
      // Where the neighbours need two lines, so has this one.
      if (plans_[i].header > headerOf(plans_[i])) plans_[i].headingBesideLabel = false;
      placeLabel(plans_[i]);
      if (i % columns + 1 == columns) top = plotTop + plotHeight + feet[i / columns];
    }
    canvas_ = Canvas(slideHeight);
  }

  /// Whether the heading, over the middle of the plot, leaves room for the y label at the column's beginning.
  bool fitsBesideLabel(const PanelPlan& plan) const {
    const Panel& panel = *plan.panel;
    if (panel.heading.empty() || panel.field || plan.key.size() > 1 || !plan.key.front().empty()) return false;
    const double middle = 0.5 * (plan.leftMargin + columnWidth());
    return middle - 0.5 * headingWidth(panel) > slideIndent + widthOf(panel.yLabel) + 10;
  }

  static double headingWidth(const Panel& panel) {
    return headingCharacter * static_cast<double>(panel.heading.size());
  }

  /// Over the numbers of the y axis, further left where the heading would touch it.
  static void placeLabel(PanelPlan& plan) {
    plan.labelLeft = plan.box.left - std::min(labelIndent, plan.leftMargin - slideIndent);
    if (!plan.headingBesideLabel) return;
    const double heading = 0.5 * (plan.box.left + plan.box.right) - 0.5 * headingWidth(*plan.panel);
    plan.labelLeft = std::min(plan.labelLeft, heading - 10 - widthOf(plan.panel->yLabel));
  }

  static double headerOf(const PanelPlan& plan) {
    return rowHeight * static_cast<double>(plan.key.size()) + headerFoot +
           (plan.panel->heading.empty() || plan.headingBesideLabel ? 0.0 : headingHeight);
  }

  static double footOf(const PanelPlan& plan) {
    double longest = 0;
    for (const std::string& name : plan.panel->xNames) longest = std::max(longest, static_cast<double>(name.size()));
    return (plan.hasXLabel ? slideFoot : numbersFoot) + (longest > shortName ? nameWidth * longest * 0.8 - 20 : 0.0);
  }

  /// Gives both axes one scale: narrows the box about its middle, and widens a range where the box would get too slim.
  /// \param slimmest the least width of the box [px]
  static void equaliseAxes(PanelPlan& plan, double slimmest) {
    const double width = plan.box.right - plan.box.left;
    const double height = plan.box.bottom - plan.box.top;
    const double scale = std::max(plan.x.span() / width, plan.y.span() / height);  // per pixel
    if (plan.panel->field) {
      // A field fills its plot.
      plan.box.right = plan.box.left + plan.x.span() / scale;
      plan.box.top = plan.box.bottom - plan.y.span() / scale;
      return;
    }
    plan.y = widened(plan.y, scale * height);
    const double boxWidth = std::clamp(plan.x.span() / scale, slimmest, width);
    plan.x = widened(plan.x, scale * boxWidth);
    plan.box.left += 0.5 * (width - boxWidth);
    plan.box.right = plan.box.left + boxWidth;
  }

  void writeHead() {
    put("# Draws {0}.{1} from {0}.dat: gnuplot {0}.gp", figure_.id(), extension());
    put("reset");
    put("set encoding utf8");
    writeTerminal();
    put("set output '{}.{}'", figure_.id(), extension());
    writeStyles();
    put("set border 3 lc rgb '#555555' lw 1.2");
    put("set grid xtics ytics back lt 1 lc rgb '#e4e4e4' lw 1");
    put("set tics nomirror out scale 0.6 textcolor rgb '#333333'");
    put("set xtics offset 0,0.3");
    put("set format '%.10g'");
    if (figure_.hasLogX()) put("set logscale x");
    put("set multiplot");
    put("unset key");
    put("set label {} at screen {},{} left font ',{:.0f}' textcolor rgb '#111111' noenhanced", quoted(figure_.title()),
        canvas_.x(20), canvas_.y(32), titleSize());
  }

  const char* extension() const { return format_ == Format::Pdf ? "pdf" : format_ == Format::Png ? "png" : "svg"; }

  void writeTerminal() {
    const double height = canvas_.height();
    if (format_ == Format::Svg) {
      put("set terminal svg size {:.0f},{:.0f} dynamic enhanced font 'sans-serif,17' background '#ffffff' name '{}'",
          canvasWidth, height, figure_.id());
    } else if (format_ == Format::Png) {
      // Font sizes count points of 1/72 inch in these terminals, pixels in SVG: 3/4.
      put("set terminal pngcairo size {:.0f},{:.0f} enhanced font 'sans-serif,17' fontscale {:.4f} linewidth {:.4f} "
          "pointscale {:.4f} background '#ffffff'",
          canvasWidth * scaleOfSlides, height * scaleOfSlides, scaleOfSlides * 0.75, scaleOfSlides, scaleOfSlides);
    } else {
      put("set terminal pdfcairo size {:.4f}in,{:.4f}in enhanced font 'sans-serif,17' fontscale 0.75 linewidth 1 "
          "pointscale 1 background '#ffffff'",
          canvasWidth / 96.0, height / 96.0);
    }
  }

  /// Font size of the title [px]: smaller when it is long, so that it stays on the canvas.
  double titleSize() const {
    constexpr double usual = 21;
    constexpr double widthPerSize = 0.56;  // of a character, in font sizes
    const double fitting = (canvasWidth - 40) / (widthPerSize * static_cast<double>(figure_.title().size() + 1));
    return std::clamp(fitting, 10.0, usual);
  }

  /// Okabe and Ito (2008) without their yellow, which a projector swallows; the second round is dashed.
  void writeStyles() {
    constexpr const char* palette[] = {"#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9"};
    constexpr int markers[] = {7, 5, 9, 13, 11, 15};  // filled: disc, square, triangle, diamond ...
    for (int i = 0; i < styleCount_; ++i) {
      put("set style line {} lc rgb '{}' lw 2.4 dt {} pt {} ps 0.8", i + 1, palette[i % 6], i < 6 ? "1" : "(8,4)",
          markers[i % 6]);
      put("set style line {} lc rgb '{}' lw 1 pt 5 ps 1.6", i + 1 + cellStyle, palette[i % 6]);
    }
    put("set style line {} lc rgb '#9a9a9a' lw 5 dt (5,2.5) pt 6 ps 1.2", referenceStyle);
  }

  void writePanel(const PanelPlan& plan, bool isFirst, bool isLast) {
    const Box& box = plan.box;
    put("");
    if (!isFirst) put("unset label; unset arrow; unset colorbox");
    put("set lmargin at screen {}; set rmargin at screen {}", canvas_.x(box.left), canvas_.x(box.right));
    put("set tmargin at screen {}; set bmargin at screen {}", canvas_.y(box.top), canvas_.y(box.bottom));
    // Before the range, which the axis of the panel before may not be able to have.
    put("{}", plan.panel->logY ? "set logscale y; set format y '10^{%T}'" : "unset logscale y; set format y '%.10g'");
    if (figure_.isSlide()) put("{}", logX(*plan.panel) ? "set logscale x" : "unset logscale x");
    put("set xrange [{:.15g}:{:.15g}]", plan.x.low, plan.x.high);
    put("set yrange [{:.15g}:{:.15g}]", plan.y.low, plan.y.high);
    const bool hasOwnX = isLast || figure_.isSlide();
    const char* xFormat = logX(*plan.panel) ? "10^{%T}" : "%.10g";
    put("set format x '{}'", hasOwnX ? xFormat : "");
    if (figure_.isSlide()) writeAxes(plan);
    if (hasOwnX && plan.hasXLabel) {
      const double below = footOf(plan) - (figure_.isSlide() ? 14 : 12);
      putText(xLabelOf(*plan.panel), 0.5 * (box.left + box.right), box.bottom + below, "center");
    }
    const double firstRow = box.top - headerFoot - rowHeight * (static_cast<double>(plan.key.size()) - 0.5);
    putText(plan.panel->yLabel, plan.labelLeft, firstRow, "left");
    const double common = keyColumn(plan);
    for (std::size_t row = 0; row < plan.key.size(); ++row) {
      writeKeyRow(plan.key[row], firstRow + rowHeight * static_cast<double>(row), plan, common);
    }
    writeCurves(plan);
  }

  void putText(const std::string& text, double x, double y, const char* side) {
    if (text.empty()) return;
    put("set label {} at screen {},{} {} noenhanced textcolor rgb '#111111'", quoted(text), canvas_.x(x), canvas_.y(y),
        side);
  }

  /// What only a slide's panel has: names along the axes, heading, notes, the colours of a field.
  void writeAxes(const PanelPlan& plan) {
    const Panel& panel = *plan.panel;
    const Box& box = plan.box;
    const double width = box.right - box.left, height = box.bottom - box.top;
    writeTics('x', panel.xNames, logX(panel) ? logTicFactor(plan.x, width, 56) : xTicStep(plan.x, width));
    writeTics('y', panel.yNames, panel.logY ? logTicFactor(plan.y, height, 32) : yTicStep(plan.y, height));
    if (!panel.heading.empty()) writeHeading(plan);
    for (const Note& note : panel.notes) {
      // A field is dark almost everywhere.
      put("set label {} at {:.10g},{:.10g} {} front noenhanced font ',{}' textcolor rgb '{}'", quoted(note.text),
          note.x, note.y, note.centred ? "center" : "left offset character 0.7,0", panel.xNames.empty() ? 16 : 10,
          panel.field ? "#ffffff" : "#111111");
    }
    if (!panel.field) return;
    // Viridis: seen by the colour-blind, and still ordered in grey.
    put("set palette maxcolors 24 defined (0 '#440154', 1 '#3b528b', 2 '#21918c', 3 '#5ec962', 4 '#fde725')");
    put("set colorbox user origin screen {},{} size screen {},{}", canvas_.x(box.right + 12), canvas_.y(box.bottom),
        canvas_.x(14), fmt::format("{:.5f}", (box.bottom - box.top) / canvas_.height()));
    if (const FixedRange& ends = panel.field->range) {
      put("set cbrange [{:.10g}:{:.10g}]", ends->first, ends->second);
    } else {
      put("set cbrange [*:*]");
    }
    putText(panel.field->label, box.right + colourScale, box.top - headerFoot - 0.5 * rowHeight, "right");
  }

  /// Over the plot, on one line with the others of its row; moved aside and made smaller to stay in its column.
  void writeHeading(const PanelPlan& plan) {
    const double width = headingWidth(*plan.panel);
    const double size = std::clamp(18 * columnWidth() / width, 11.0, 18.0);
    const double half = 0.5 * std::min(width * size / 18, columnWidth() - 1);
    const double middle = std::clamp(0.5 * (plan.box.left + plan.box.right), plan.columnLeft + half,
                                     plan.columnLeft + columnWidth() - half);
    put("set label {} at screen {},{} center noenhanced font ',{:.1f}' textcolor rgb '#111111'",
        quoted(plan.panel->heading), canvas_.x(middle), canvas_.y(plan.box.top - plan.header + 0.5 * rowHeight), size);
  }

  /// Names, or numbers at a distance; both anew for each panel, since settings last.
  void writeTics(char axis, const std::vector<std::string>& names, double step) {
    if (names.empty()) {
      put("set {0}tics autofreq {1:.10g} norotate font ',17'", axis, step);
      return;
    }
    std::string list;
    double longest = 0;
    for (std::size_t i = 0; i < names.size(); ++i) {
      list += fmt::format("{}{} {}", i == 0 ? "" : ", ", quoted(names[i]), i);
      longest = std::max(longest, static_cast<double>(names[i].size()));
    }
    const bool rotate = axis == 'x' && longest > shortName;
    put("set {}tics ({}) {} font ',13' noenhanced", axis, list, rotate ? "rotate by 50 right" : "norotate");
  }

  /// Where the samples of a key with one name a row begin, one below the other; negative where rows stand for
  /// themselves.
  double keyColumn(const PanelPlan& plan) const {
    double widest = 0;
    for (const std::vector<Curve>& row : plan.key) {
      if (row.size() > 1) return -1;
      for (const Curve& curve : row) widest = std::max(widest, curve.widthInKey());
    }
    const double x = keyRight(plan) - widest;
    const double label = plan.key.front().empty() ? 0.0 : widthOf(plan.panel->yLabel) + entryGap;
    return x < plan.labelLeft + label ? -1 : x;
  }

  /// One row of the key, flush right. Drawn by hand, because gnuplot gives all names the width of the longest.
  void writeKeyRow(const std::vector<Curve>& row, double y, const PanelPlan& plan, double common) {
    double x = keyRight(plan) + entryGap;
    for (const Curve& curve : row) x -= curve.widthInKey() + entryGap;
    x = std::max(x, plan.labelLeft);  // a name wider than the canvas shows its beginning
    if (common >= 0) x = common;
    for (const Curve& curve : row) {
      if (curve.asPoints) {
        put("set label '' at screen {},{} point ls {}", canvas_.x(x + 0.5 * sampleLength), canvas_.y(y),
            curve.markStyle);
      } else {
        if (curve.series->pen == Pen::LinePoints) {
          put("set label '' at screen {},{} point ls {}", canvas_.x(x + 0.5 * sampleLength), canvas_.y(y), curve.style);
        }
        put("set arrow from screen {1},{0} to screen {2},{0} {4} ls {3}", canvas_.y(y), canvas_.x(x),
            canvas_.x(x + sampleLength), curve.style,
            curve.series->pen == Pen::Arrows ? "head size screen 0.012,20 filled" : "nohead");
      }
      putText(curve.nameInKey(), x + sampleLength + sampleGap, y, "left");
      x += curve.widthInKey() + entryGap;
    }
  }

  /// References first, so that they lie underneath.
  void writeCurves(const PanelPlan& plan) {
    std::string curves;
    const auto add = [&](bool references) {
      for (const Curve& curve : plan.curves) {
        if (curve.block < 0 || (curve.series->pen == Pen::Reference) != references) continue;
        curves += fmt::format("{}'{}.dat' index {} {}", curves.empty() ? "" : ", \\\n     ", figure_.id(), curve.block,
                              mannerOf(curve));
      }
    };
    if (plan.fieldBlock >= 0) {
      curves = fmt::format("'{}.dat' index {} using 1:2:3 with image", figure_.id(), plan.fieldBlock);
    }
    add(true);
    add(false);
    if (curves.empty()) put("set label 'no data' at graph 0.5,0.5 center textcolor rgb '#777777'");
    put("plot {}", curves.empty() ? "NaN" : curves);
  }

  static std::string mannerOf(const Curve& curve) {
    if (curve.series->pen == Pen::Arrows) {
      return fmt::format("using 1:2:3:4 with vectors head size screen 0.012,20 filled ls {}", curve.style);
    }
    if (curve.series->pen == Pen::Cells) {
      return fmt::format("using 1:2:(0.47):(0.47) with boxxyerror fs solid 1 noborder ls {}", curve.style);
    }
    const char* lines = curve.series->pen == Pen::LinePoints ? "linespoints" : "lines";
    return fmt::format("using 1:2 with {} ls {}", curve.asPoints ? "points" : lines, curve.style);
  }

  /// The key ends with the plot; where equal axes made the plot narrow, with the panel.
  double keyRight(const PanelPlan& plan) const {
    const double scale = plan.panel->field ? colourScale : 0.0;
    return figure_.isSlide() ? plan.box.right + scale - besideKey(*plan.panel) : plotRight;
  }

  static constexpr int mostStyles = 12;
  static constexpr int referenceStyle = 20;
  static constexpr int cellStyle = 30;    // added to the style of a curve
  static constexpr double shortName = 4;  // characters; longer names under the x axis are turned

  const Figure& figure_;
  Format format_;
  int styleCount_ = 0;
  int blocks_ = 0;
  Canvas canvas_;
  std::vector<PanelPlan> plans_;
  std::string data_;
  std::string script_;
};

}  // namespace

FigureText figureText(const Figure& figure, Format format) { return ScriptWriter(figure, format).write(); }

}  // namespace muelle
