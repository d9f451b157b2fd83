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
constexpr double titleHeight = 52;
constexpr double rowHeight = 28;  // a row above a panel: the y label, or part of the key
constexpr double panelGap = 22;
constexpr double footHeight = 74;  // numbers and label of the x axis
constexpr double singleHeight = 386;
constexpr double stackedHeight = 196;
constexpr double equalHeight = 500;
constexpr double characterWidth = 9.6;  // of the 17 px font, generous
constexpr double sampleWidth = 62;      // the piece of line before a name in the key

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

/// Characters on the screen, from those of UTF-8.
double widthOf(const std::string& text) { return characterWidth * static_cast<double>(text.size()); }

/// A curve as the script knows it.
struct Curve {
  const Series* series;
  int block;          ///< index in the data file; -1: no point to draw
  std::string style;  ///< "lines ls 1"
};

struct KeyLayout {
  int columns = 1;
  int rows = 0;
  bool besideLabel = false;  ///< one row that fits to the right of the y label
};

std::string nameInKey(const Curve& curve) {
  const std::string& name = curve.series->name;
  return curve.block >= 0 || name.empty() ? name : name + " (no data)";
}

KeyLayout keyLayout(const std::vector<Curve>& curves, const std::string& yLabel) {
  double entry = 0;
  int count = 0;
  for (const Curve& curve : curves) {
    if (curve.series->name.empty()) continue;
    entry = std::max(entry, widthOf(nameInKey(curve)) + sampleWidth);
    ++count;
  }
  if (count == 0) return {};
  const double width = plotRight - plotLeft;
  KeyLayout layout;
  layout.besideLabel = count * entry + widthOf(yLabel) + 40 < plotRight - 24;
  layout.columns = layout.besideLabel ? count : std::clamp(static_cast<int>(width / entry), 1, count);
  layout.rows = (count + layout.columns - 1) / layout.columns;
  return layout;
}

/// Where a panel lies: pixels from the top left corner.
struct Box {
  double left, right, top, bottom;
};

struct PanelPlan {
  const Panel* panel;
  std::vector<Curve> curves;
  KeyLayout key;
  double header;  ///< height of the rows above the plot
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
      PanelPlan plan{&panel, {}, {}, 0, {}, {}, {}};
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
      plan.key = keyLayout(plan.curves, panel.yLabel);
      plan.header = rowHeight * (plan.key.besideLabel ? 1 : 1 + plan.key.rows);
      plan.y = ys.range(0.06);
      plans_.push_back(std::move(plan));
    }
    for (PanelPlan& plan : plans_) plan.x = xs.range(points ? 0.04 : 0.0);
  }

  void addBlock(const Series& series, const Panel& panel, int& blocks, PanelPlan& plan, int& colour) {
    const std::string lines = dataBlock(series, figure_.hasLogX(), panel.logY);
    // A line through one point would not be seen.
    const bool isOnePoint = std::count(lines.begin(), lines.end(), '\n') == 1;
    const int style = series.pen == Pen::Reference ? 20 : 1 + colour++ % 12;
    const char* pen = series.pen == Pen::Points || isOnePoint ? "points" : "lines";
    plan.curves.push_back({&series, lines.empty() ? -1 : blocks, fmt::format("{} ls {}", pen, style)});
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
      y += plan.header;
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
    put("set format '%.8g'");
    if (figure_.hasLogX()) put("set logscale x");
    put("set multiplot");
    put("set label 1 {} at screen {},{} left font ',21' textcolor rgb '#111111' noenhanced", quoted(figure_.title()),
        canvas_.x(20), canvas_.y(32));
  }

  /// Okabe and Ito (2008) without their yellow, which a projector swallows; the second round is dashed.
  void writeStyles() {
    constexpr const char* palette[] = {"#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9"};
    constexpr int markers[] = {7, 5, 9, 13, 11, 15};  // filled: disc, square, triangle, diamond ...
    for (int i = 0; i < 12; ++i) {
      put("set style line {} lc rgb '{}' lw 2.4 dt {} pt {} ps 0.7", i + 1, palette[i % 6], i < 6 ? "1" : "(8,4)",
          markers[i % 6]);
    }
    put("set style line 20 lc rgb '#9a9a9a' lw 5 dt (2.2,1.4) pt 6 ps 1.2");
  }

  void writePanel(const PanelPlan& plan, bool isFirst, bool isLast) {
    const Box& box = plan.box;
    if (!isFirst) put("unset label 1");
    put("set lmargin at screen {}; set rmargin at screen {}", canvas_.x(box.left), canvas_.x(box.right));
    put("set tmargin at screen {}; set bmargin at screen {}", canvas_.y(box.top), canvas_.y(box.bottom));
    put("set xrange [{:.10g}:{:.10g}]", plan.x.low, plan.x.high);
    put("set yrange [{:.10g}:{:.10g}]", plan.y.low, plan.y.high);
    put("{}", plan.panel->logY ? "set logscale y; set format y '10^{%T}'" : "unset logscale y; set format y '%.8g'");
    if (isLast) {
      put("set format x {}; set xlabel {} noenhanced", figure_.hasLogX() ? "'10^{%T}'" : "'%.8g'",
          quoted(figure_.xLabel()));
    } else {
      put("set format x ''; unset xlabel");
    }
    put("set label 2 {} at screen {},{} left noenhanced textcolor rgb '#111111'", quoted(plan.panel->yLabel),
        canvas_.x(24), canvas_.y(box.top - plan.header + 14));
    writeKey(plan);
    writeCurves(plan);
  }

  void writeKey(const PanelPlan& plan) {
    if (plan.key.rows == 0) {
      put("unset key");
      return;
    }
    const double top = plan.box.top - rowHeight * plan.key.rows - 6;
    put("set key at screen {},{} right top horizontal Left reverse noenhanced samplen 2.2 maxcols {}",
        canvas_.x(plotRight), canvas_.y(top), plan.key.columns);
  }

  /// References first, so that they lie underneath; their names follow in the key.
  void writeCurves(const PanelPlan& plan) {
    std::string drawn;
    std::string named;
    for (const Curve& curve : plan.curves) {
      const bool isReference = curve.series->pen == Pen::Reference;
      const std::string name = nameInKey(curve);
      if (curve.block >= 0) {
        const std::string plot =
            fmt::format("  '{}.dat' index {} using 1:2 with {} notitle", figure_.id(), curve.block, curve.style);
        drawn = isReference ? plot + ", \\\n" + drawn : drawn + plot + ", \\\n";
      }
      if (!name.empty()) named += fmt::format("  keyentry with {} title {}, \\\n", curve.style, quoted(name));
    }
    if (drawn.empty()) {
      put("set label 3 'no data' at graph 0.5,0.5 center textcolor rgb '#777777'");
      drawn = "  NaN notitle, \\\n";
    }
    const std::string all = drawn + named;
    put("plot \\\n{}", all.substr(0, all.size() - 4));  // without the last ", \" and line end
    put("unset label 3");
  }

  const Figure& figure_;
  Canvas canvas_;
  std::vector<PanelPlan> plans_;
  std::string data_;
  std::string script_;
};

}  // namespace

FigureText figureText(const Figure& figure) { return ScriptWriter(figure).write(); }

}  // namespace muelle
