#include "figures/style_script.h"

#include "figures/line_styles.h"
#include "figures/script_text.h"

namespace muelle::figures {

namespace {

void putTerminal(const std::string& id, const Layout& layout, Format format, ScriptText& script) {
  constexpr double pngScale = 4.0 / 3.0;  // 1280 pixels for 960
  constexpr double pixelsPerInch = 96;
  // Font sizes count points of 1/72 inch in these terminals, pixels in SVG: 3/4.
  constexpr double fontScale = 0.75;
  if (format == Format::Svg) {
    script.put(
        "set terminal svg size {:.0f},{:.0f} dynamic enhanced font 'sans-serif,17' background '#ffffff' name '{}'",
        layout.width, layout.height, id);
  } else if (format == Format::Png) {
    script.put(
        "set terminal pngcairo size {:.0f},{:.0f} enhanced font 'sans-serif,17' fontscale {:.4f} linewidth {:.4f} "
        "pointscale {:.4f} background '#ffffff'",
        layout.width * pngScale, layout.height * pngScale, pngScale * fontScale, pngScale, pngScale);
  } else {
    script.put(
        "set terminal pdfcairo size {:.4f}in,{:.4f}in enhanced font 'sans-serif,17' fontscale {:.2f} linewidth 1 "
        "pointscale 1 background '#ffffff'",
        layout.width / pixelsPerInch, layout.height / pixelsPerInch, fontScale);
  }
}

/// Okabe and Ito (2008) without their yellow, which a projector swallows; the second round is dashed.
void putLineStyles(int count, ScriptText& script) {
  constexpr const char* palette[] = {"#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9"};
  constexpr int markers[] = {7, 5, 9, 13, 11, 15};  // filled: disc, square, triangle, diamond ...
  for (int i = 0; i < count; ++i) {
    script.put("set style line {} lc rgb '{}' lw 2.4 dt {} pt {} ps 0.8", i + 1, palette[i % 6], i < 6 ? "1" : "(8,4)",
               markers[i % 6]);
    script.put("set style line {} lc rgb '{}' lw 1 pt 5 ps 1.6", i + 1 + cellStyle, palette[i % 6]);
    script.put("set style line {} lc rgb '{}' lw 0.7 dt 1", i + 1 + meshStyle, palette[i % 6]);
  }
  script.put("set style line {} lc rgb '#9a9a9a' lw 5 dt (5,2.5) pt 6 ps 1.2", referenceStyle);
  script.put("set style line {} lc rgb '#9a9a9a' lw 2 dt 1 pt 6 ps 1.2", structureStyle);
  script.put("set style line {} lc rgb '#222222' lw 1 dt 1 pt 7 ps 1.1", nodeStyle);
}

void putFrame(const Figure& figure, ScriptText& script) {
  script.put("set border 3 lc rgb '#555555' lw 1.2");
  script.put("set grid xtics ytics back lt 1 lc rgb '#e4e4e4' lw 1");
  script.put("set tics nomirror out scale 0.6 textcolor rgb '#333333'");
  script.put("set xtics offset 0,0.3");
  script.put("set format '%.10g'");
  script.put("set minussign");
  if (figure.hasLogX()) script.put("set logscale x");
  script.put("set multiplot");
  script.put("unset key");
}

}  // namespace

std::string headOfScript(const Figure& figure, const FigureData& data, const Layout& layout, Format format) {
  ScriptText script(layout.width, layout.height);
  const std::string& id = figure.id();
  script.put("# Draws {0}.{1} from {0}.dat: gnuplot {0}.gp", id, extensionOf(format));
  script.put("reset");
  script.put("set encoding utf8");
  putTerminal(id, layout, format, script);
  script.put("set output '{}.{}'", id, extensionOf(format));
  putLineStyles(data.styleCount, script);
  putFrame(figure, script);
  script.putLabel(figure.title(), layout.title, fmt::format("{:.0f}", layout.titleSize));
  return script.lines();
}

}  // namespace muelle::figures
