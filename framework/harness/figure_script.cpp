#include "harness/figure_script.h"

#include "harness/figure_axis.h"
#include "harness/figure_data.h"

#include <fmt/format.h>
#include <algorithm>

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
constexpr double characterWidth = 9.0;  // of the 17 px font, on the generous side: the viewer chooses the face
constexpr double sampleLength = 40;     // the piece of line before a name in the key
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
  int style;  ///< number of the line style

  std::string nameInKey() const {
    return block >= 0 || series->name.empty() ? series->name : series->name + " (no data)";
  }
  double widthInKey() const { return sampleLength + sampleGap + widthOf(nameInKey()); }
};

/// The curves that have a name, in rows from the top. The first row shares its line with the y label and may be empty.
using KeyRows = std::vector<std::vector<Curve>>;

KeyRows keyRows(const std::vector<Curve>& curves, const std::string& yLabel) {
  KeyRows rows(1);
  double room = plotRight - plotLeft + labelIndent - widthOf(yLabel) - entryGap;
  for (const Curve& curve : curves) {
    if (curve.series->name.empty()) continue;
    const double width = curve.widthInKey() + entryGap;
    const bool isAlone = rows.size() > 1 && rows.back().empty();
    if (width > room && !isAlone) {
      rows.emplace_back();
      room = plotRight - plotLeft;
    }
    room -= width;
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
};

bool anyPoints(const Panel& panel) {
  return std::any_of(panel.series.begin(), panel.series.end(), [](const Series& s) { return s.pen == Pen::Points; });
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
  explicit ScriptWriter(const Figure& figure) : figure_(figure), canvas_(0) {
    planPanels();
    placePanels();
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
    AxisFitter xs(figure_.hasLogX());
    bool points = figure_.hasEqualAxes();
    int blocks = 0;
    data_ = "# " + figure_.title() + '\n';
    for (const Panel& panel : figure_.panels()) {
      points = points || anyPoints(panel);
      PanelPlan plan{&panel, {}, {}, {}, {}, {}};
      AxisFitter ys(panel.logY);
      int colour = 0;
      for (const Series* series : inKeyOrder(panel)) {
        addBlock(*series, panel, blocks, plan, colour);
        for (std::size_t i = 0; i < series->x.size(); ++i) {
          if (!isDrawable(series->x[i], figure_.hasLogX()) || !isDrawable(series->y[i], panel.logY)) continue;
          xs.include(series->x[i]);
          ys.include(series->y[i]);
        }
      }
      plan.key = keyRows(plan.curves, panel.yLabel);
      plan.y = ys.range(0.06);
      plans_.push_back(std::move(plan));
    }
    for (PanelPlan& plan : plans_) plan.x = xs.range(points ? 0.04 : 0.0);
  }

  void addBlock(const Series& series, const Panel& panel, int& blocks, PanelPlan& plan, int& colour) {
    const std::string lines = dataBlock(series, figure_.hasLogX(), panel.logY);
    // A line through one point would not be seen.
    const bool isOnePoint = std::count(lines.begin(), lines.end(), '\n') == 1;
    const int style = series.pen == Pen::Reference ? referenceStyle : 1 + colour++ % mostStyles;
    styleCount_ = std::max(styleCount_, std::min(colour, mostStyles));
    const bool asPoints = series.pen == Pen::Points || isOnePoint;
    plan.curves.push_back({&series, lines.empty() ? -1 : blocks, asPoints, style});
    if (lines.empty()) return;
    data_ += fmt::format("{}# block {}: {}; columns: {}, {}\n{}", blocks > 0 ? "\n\n" : "", blocks, series.name,
                         figure_.xLabel(), panel.yLabel, lines);
    ++blocks;
  }

  void placePanels() {
    double plotHeight = plans_.size() == 1 ? singleHeight : stackedHeight;
    if (figure_.hasEqualAxes() && plans_.size() == 1) plotHeight = equalHeight;
    double y = titleHeight;
    for (PanelPlan& plan : plans_) {
      y += rowHeight * static_cast<double>(plan.key.size()) + headerFoot;
      plan.box = {plotLeft, plotRight, y, y + plotHeight};
      if (figure_.hasEqualAxes()) equaliseAxes(plan);
      y += plotHeight + panelGap;
    }
    canvas_ = Canvas(y - panelGap + footHeight);
  }

  /// Gives both axes one scale: narrows the box about its middle, and widens a range where the box would get too slim.
  static void equaliseAxes(PanelPlan& plan) {
    constexpr double slimmest = 360;
    const double width = plan.box.right - plan.box.left;
    const double height = plan.box.bottom - plan.box.top;
    const double scale = std::max(plan.x.span() / width, plan.y.span() / height);  // per pixel
    plan.y = widened(plan.y, scale * height);
    const double boxWidth = std::clamp(plan.x.span() / scale, slimmest, width);
    plan.x = widened(plan.x, scale * boxWidth);
    plan.box.left += 0.5 * (width - boxWidth);
    plan.box.right = plan.box.left + boxWidth;
  }

  void writeHead() {
    put("# Draws {0}.svg from {0}.dat: gnuplot {0}.gp", figure_.id());
    put("reset");
    put("set encoding utf8");
    put("set terminal svg size {:.0f},{:.0f} dynamic enhanced font 'sans-serif,17' background '#ffffff' name '{}'",
        canvasWidth, canvas_.height(), figure_.id());
    put("set output '{}.svg'", figure_.id());
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
    }
    put("set style line {} lc rgb '#9a9a9a' lw 5 dt (5,2.5) pt 6 ps 1.2", referenceStyle);
  }

  void writePanel(const PanelPlan& plan, bool isFirst, bool isLast) {
    const Box& box = plan.box;
    put("");
    if (!isFirst) put("unset label; unset arrow");
    put("set lmargin at screen {}; set rmargin at screen {}", canvas_.x(box.left), canvas_.x(box.right));
    put("set tmargin at screen {}; set bmargin at screen {}", canvas_.y(box.top), canvas_.y(box.bottom));
    put("set xrange [{:.15g}:{:.15g}]", plan.x.low, plan.x.high);
    put("set yrange [{:.15g}:{:.15g}]", plan.y.low, plan.y.high);
    put("{}", plan.panel->logY ? "set logscale y; set format y '10^{%T}'" : "unset logscale y; set format y '%.10g'");
    const char* xFormat = figure_.hasLogX() ? "10^{%T}" : "%.10g";
    put("set format x '{}'", isLast ? xFormat : "");
    if (isLast) putText(figure_.xLabel(), 0.5 * (box.left + box.right), box.bottom + 54, "center");
    const double firstRow = box.top - headerFoot - rowHeight * (static_cast<double>(plan.key.size()) - 0.5);
    putText(plan.panel->yLabel, box.left - labelIndent, firstRow, "left");
    for (std::size_t row = 0; row < plan.key.size(); ++row) {
      writeKeyRow(plan.key[row], firstRow + rowHeight * static_cast<double>(row));
    }
    writeCurves(plan);
  }

  void putText(const std::string& text, double x, double y, const char* side) {
    if (text.empty()) return;
    put("set label {} at screen {},{} {} noenhanced textcolor rgb '#111111'", quoted(text), canvas_.x(x), canvas_.y(y),
        side);
  }

  /// One row of the key, flush right. Drawn by hand, because gnuplot gives all names the width of the longest.
  void writeKeyRow(const std::vector<Curve>& row, double y) {
    double x = plotRight + entryGap;
    for (const Curve& curve : row) x -= curve.widthInKey() + entryGap;
    x = std::max(x, plotLeft - labelIndent);  // a name wider than the canvas shows its beginning
    for (const Curve& curve : row) {
      if (curve.asPoints) {
        put("set label '' at screen {},{} point ls {}", canvas_.x(x + 0.5 * sampleLength), canvas_.y(y), curve.style);
      } else {
        put("set arrow from screen {1},{0} to screen {2},{0} nohead ls {3}", canvas_.y(y), canvas_.x(x),
            canvas_.x(x + sampleLength), curve.style);
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
        curves += fmt::format("{}'{}.dat' index {} using 1:2 with {} ls {}", curves.empty() ? "" : ", \\\n     ",
                              figure_.id(), curve.block, curve.asPoints ? "points" : "lines", curve.style);
      }
    };
    add(true);
    add(false);
    if (curves.empty()) put("set label 'no data' at graph 0.5,0.5 center textcolor rgb '#777777'");
    put("plot {}", curves.empty() ? "NaN" : curves);
  }

  static constexpr int mostStyles = 12;
  static constexpr int referenceStyle = 20;

  const Figure& figure_;
  int styleCount_ = 0;
  Canvas canvas_;
  std::vector<PanelPlan> plans_;
  std::string data_;
  std::string script_;
};

}  // namespace

FigureText figureText(const Figure& figure) { return ScriptWriter(figure).write(); }

}  // namespace muelle
