#include "figures/panel_script.h"

#include "base/text/lists.h"
#include "figures/measures.h"
#include "figures/ranges.h"
#include "figures/script_text.h"

#include <algorithm>

namespace muelle::figures {

namespace {

constexpr const char* arrowHead = "head size screen 0.012,20 filled";
constexpr const char* powersOfTen = "10^{%T}";
constexpr const char* plainNumbers = "%.10g";
constexpr const char* shortNumbers = "%.4g";

const char* setOrUnset(bool set) { return set ? "set" : "unset"; }

const char* numbersOf(bool logarithmic, const AxisRange& range) {
  if (logarithmic) return powersOfTen;
  return needsShortNumbers(range) ? shortNumbers : plainNumbers;
}

/// How a number stands on a scale of colours.
std::string onScale(double value) { return fmt::format("{:.10g}", value == 0.0 ? 0.0 : value); }

/// The ends of the scale that values go beyond, as marks that say so.
std::string cutMarks(const Field& field) {
  if (!field.range) return "";
  const auto [low, high] = *field.range;
  const auto isBelow = [low = low](double value) { return value < low; };
  const auto isAbove = [high = high](double value) { return value > high; };
  std::string marks;
  if (std::any_of(field.values.begin(), field.values.end(), isBelow)) {
    marks = fmt::format("'≤{0}' {0}", onScale(low));
  }
  if (std::any_of(field.values.begin(), field.values.end(), isAbove)) {
    marks += fmt::format("{0}'≥{1}' {1}", marks.empty() ? "" : ", ", onScale(high));
  }
  return marks;
}

bool isUnderneath(Pen pen) { return pen == Pen::Reference || pen == Pen::Structure; }

std::string mannerOf(const Curve& curve) {
  if (curve.series->pen == Pen::Arrows) {
    return fmt::format("using 1:2:3:4 with vectors {} ls {}", arrowHead, curve.style);
  }
  if (curve.series->pen == Pen::Cells) {
    return fmt::format("using 1:2:(0.47):(0.47) with boxxyerror fs solid 1 noborder ls {}", curve.style);
  }
  const char* lines = curve.series->pen == Pen::LinePoints ? "linespoints" : "lines";
  return fmt::format("using 1:2 with {} ls {}", curve.asPoints ? "points" : lines, curve.style);
}

class PanelScript {
 public:
  PanelScript(const Figure& figure, std::size_t index, const PanelCurves& drawn, const Layout& layout)
      : figure_(figure),
        panel_(figure.panels()[index]),
        drawn_(drawn),
        place_(layout.panels[index]),
        isFirst_(index == 0),
        hasNumbersBelow_(figure.isSlide() || index + 1 == figure.panels().size()),
        script_(layout.width, layout.height) {}

  std::string write() {
    script_.put("");
    if (!isFirst_) script_.put("unset label; unset arrow; unset colorbox");
    writePlotAndScales();
    if (figure_.isSlide()) writeSlideParts();
    if (place_.xLabel) script_.putLabel(xLabelOf(figure_, panel_), *place_.xLabel);
    script_.putLabel(panel_.yLabel, place_.yLabel);
    writeKey();
    writeCurves();
    return script_.lines();
  }

 private:
  void writePlotAndScales() {
    const Box& plot = place_.plot;
    script_.put("set lmargin at screen {}; set rmargin at screen {}", script_.x(plot.left), script_.x(plot.right));
    script_.put("set tmargin at screen {}; set bmargin at screen {}", script_.y(plot.top), script_.y(plot.bottom));
    // Before the range, which the axis of the panel before may not be able to have.
    script_.put("{} logscale y; set format y '{}'", setOrUnset(panel_.logY), numbersOf(panel_.logY, place_.y));
    const bool logX = hasLogX(figure_, panel_);
    if (figure_.isSlide()) script_.put("{} logscale x", setOrUnset(logX));
    script_.put("set xrange [{:.15g}:{:.15g}]", place_.x.low, place_.x.high);
    script_.put("set yrange [{:.15g}:{:.15g}]", place_.y.low, place_.y.high);
    script_.put("set format x '{}'", hasNumbersBelow_ ? numbersOf(logX, place_.x) : "");
  }

  /// What only a slide's panel has: numbers or names at a distance of its own, heading, notes, the colours of a field.
  void writeSlideParts() {
    writeTics("x", panel_.xNames, place_.xStep, place_.turnsXNames);
    writeTics("y", panel_.yNames, place_.yStep, false);
    if (place_.heading) script_.putLabel(panel_.heading, *place_.heading, fmt::format("{:.1f}", place_.headingSize));
    for (const Note& note : panel_.notes) writeNote(note);
    if (panel_.field) writeColours(*panel_.field);
  }

  /// Anew for each panel, since settings last.
  void writeTics(const char* axis, const std::vector<std::string>& names, double step, bool turned) {
    if (names.empty()) {
      script_.put("set {0}tics autofreq {1:.10g} norotate font ',17'", axis, step);
      return;
    }
    std::string list;
    for (std::size_t i = 0; i < names.size(); ++i) {
      list += fmt::format("{}{} {}", i == 0 ? "" : ", ", quotedName(names[i]), i);
    }
    script_.put("set {}tics ({}) {} font ',13' noenhanced", axis, list, turned ? "rotate by 50 right" : "norotate");
  }

  void writeNote(const Note& note) {
    script_.put("set label {} at {:.10g},{:.10g} {} front noenhanced font ',{}' textcolor {}", quoted(note.text),
                note.x, note.y, note.centred ? "center" : "left offset character 0.7,0",
                panel_.xNames.empty() ? 16 : 10, colourOf(note));
  }

  std::string colourOf(const Note& note) const {
    if (note.curve < 0) return panel_.field ? "rgb '#ffffff'" : "rgb '#111111'";  // a field is dark almost everywhere
    const Series* named = &panel_.series[static_cast<std::size_t>(note.curve)];
    if (isUnderneath(named->pen)) return "rgb '#6a6a6a'";  // the grey of a line is too light for letters
    const auto curve =
        std::ranges::find_if(drawn_.curves, [named](const Curve& drawn) { return drawn.series == named; });
    return fmt::format("ls {}", curve->style);
  }

  void writeColours(const Field& field) {
    // Viridis: seen by the colour-blind, and still ordered in grey.
    script_.put("set palette maxcolors {} defined (0 '#440154', 1 '#3b528b', 2 '#21918c', 3 '#5ec962', 4 '#fde725')",
                field.bands);
    if (const std::optional<Box>& scale = place_.colourScale) {
      script_.put("set colorbox user origin screen {},{} size screen {},{}", script_.x(scale->left),
                  script_.y(scale->bottom), script_.x(scale->width()), script_.heightOf(scale->height()));
    }
    const FixedRange& ends = field.range;
    script_.put("set cbrange [{}]", ends ? fmt::format("{:.10g}:{:.10g}", ends->first, ends->second) : "*:*");
    script_.put("set cbtics autofreq");
    const std::string cuts = cutMarks(field);
    if (!cuts.empty()) script_.put("set cbtics add ({})", cuts);
    script_.putLabel(field.label, place_.colourLabel);
  }

  /// Drawn by hand, because gnuplot's key gives all names the width of the longest.
  void writeKey() {
    auto place = place_.key.begin();
    for (const Curve& curve : drawn_.curves) {
      if (!curve.nameInKey().empty()) writeKeyEntry(curve, *place++);
    }
  }

  void writeKeyEntry(const Curve& curve, Label place) {
    const std::string y = script_.y(place.y);
    if (curve.asPoints || curve.series->pen == Pen::LinePoints) {
      script_.put("set label '' at screen {},{} point ls {}", script_.x(place.x + 0.5 * sampleLength), y,
                  curve.asPoints ? curve.markStyle : curve.style);
    }
    if (!curve.asPoints) {
      script_.put("set arrow from screen {1},{0} to screen {2},{0} {4} ls {3}", y, script_.x(place.x),
                  script_.x(place.x + sampleLength), curve.style,
                  curve.series->pen == Pen::Arrows ? arrowHead : "nohead");
    }
    place.x += sampleLength + sampleGap;
    script_.putLabel(curve.nameInKey(), place);
  }

  /// References first, so that they lie underneath; a field under all.
  void writeCurves() {
    std::vector<std::string> curves;
    if (drawn_.fieldBlock >= 0) curves.push_back(fromBlock(drawn_.fieldBlock, "using 1:2:3 with image"));
    for (const bool underneath : {true, false}) {
      for (const Curve& curve : drawn_.curves) {
        const bool belongs = isUnderneath(curve.series->pen) == underneath;
        if (curve.block >= 0 && belongs) curves.push_back(fromBlock(curve.block, mannerOf(curve) + onField(curve)));
      }
    }
    if (curves.empty()) {
      script_.put("set label 'no data' at graph 0.5,0.5 center textcolor rgb '#777777'");
      curves.emplace_back("NaN");
    }
    script_.put("plot {}", joined(curves, ", \\\n     "));
  }

  /// A field is dark almost everywhere: lines on it are light.
  std::string onField(const Curve& curve) const {
    return panel_.field && curve.series->pen == Pen::Structure ? " lc rgb '#ffffff' lw 1" : "";
  }

  std::string fromBlock(int block, const std::string& manner) const {
    return fmt::format("'{}.dat' index {} {}", figure_.id(), block, manner);
  }

  const Figure& figure_;
  const Panel& panel_;
  const PanelCurves& drawn_;
  const PanelLayout& place_;
  bool isFirst_;
  bool hasNumbersBelow_;  ///< on the x axis; stacked panels share those of the lowest
  ScriptText script_;
};

}  // namespace

std::string panelScript(const Figure& figure, std::size_t index, const PanelCurves& drawn, const Layout& layout) {
  return PanelScript(figure, index, drawn, layout).write();
}

}  // namespace muelle::figures
