#include "base/file.h"
#include "base/text/words.h"
#include "figures/axis.h"
#include "figures/script.h"
#include "figures/write.h"
#include "support/lines.h"
#include "support/temporary.h"

#include <gtest/gtest.h>
#include <cmath>
#include <regex>

namespace muelle {
namespace {

using Numbers = std::vector<double>;
const Numbers times = {0, 1, 2, 3};

/// Where a plot lies, in parts of the canvas.
struct Plot {
  double left, right, top, bottom;
};

std::vector<Plot> plotsOf(const std::string& script) {
  std::vector<Plot> plots;
  const std::regex pattern(R"(set lmargin at screen (\S+); set rmargin at screen (\S+)\n)"
                           R"(set tmargin at screen (\S+); set bmargin at screen (\S+)\n)");
  for (std::sregex_iterator it(script.begin(), script.end(), pattern), end; it != end; ++it) {
    plots.push_back({std::stod((*it)[1]), std::stod((*it)[2]), std::stod((*it)[3]), std::stod((*it)[4])});
  }
  return plots;
}

/// Six panels with all that takes room above, below and beside a plot.
Figure crowded(int columns) {
  Figure figure("crowded", "A slide with everything on it", "time [s]");
  figure.slide(columns);
  for (int i = 0; i < 6; ++i) {
    auto panel = figure.panel("position of the free end [m]");
    panel.heading("a heading of some length");
    for (const char* name : {"velocity Verlet", "classical Runge-Kutta", "implicit midpoint"}) {
      panel.linePoints(name, times, {1e-7, 1, 10, 100});
    }
    if (i == 1) panel.logY();
    if (i == 2) panel.equalAxes();
    if (i == 3) panel.xNames({"explicit Euler", "symplectic Euler"});
    if (i == 4) panel.field({{0, 1, 2}, {0, 1}, {1, 2, 3, 4, 5, 6}, "energy [J]"});
    if (i == 5) panel.yNames({"a long name of a hard case", "another"});
  }
  return figure;
}

TEST(Slide, KeepsItsPlotsApart) {
  for (const int columns : {1, 2, 3, 6}) {
    const std::vector<Plot> plots = plotsOf(figureText(crowded(columns)).script);
    ASSERT_EQ(plots.size(), 6U);
    for (const Plot& a : plots) {
      EXPECT_GE(a.left, 0.0);
      EXPECT_LE(a.right, 1.0);
      if (columns == 3) {
        EXPECT_LT(a.left, a.right);
        EXPECT_LT(a.bottom, a.top);
      }
      for (const Plot& b : plots) {
        if (&a == &b) continue;
        const bool besides = a.right < b.left || b.right < a.left;
        const bool above = a.bottom > b.top || b.bottom > a.top;
        EXPECT_TRUE(besides || above) << columns << " columns";
      }
    }
  }
}

TEST(Slide, LinesItsPlotsUp) {
  Figure figure("rows", "Two rows, unlike above and below", "time [s]");
  figure.slide(2);
  figure.panel("y").line("a", times, times).heading("a heading");
  figure.panel("y").line("", times, times);
  figure.panel("y").line("", times, times).xLabel("step [s]");
  figure.panel("y").line("a", times, times);
  const std::vector<Plot> plots = plotsOf(figureText(figure).script);
  ASSERT_EQ(plots.size(), 4U);
  const double digits = 2e-5;  // of the margins
  for (const std::size_t row : {0U, 2U}) {
    EXPECT_NEAR(plots[row].top, plots[row + 1].top, digits);
    EXPECT_NEAR(plots[row].bottom, plots[row + 1].bottom, digits);
    EXPECT_NEAR(plots[row].top - plots[row].bottom, plots[0].top - plots[0].bottom, digits);
  }
  EXPECT_GT(plots[0].top - plots[0].bottom, 0.2);
  EXPECT_GT(plots[0].bottom - plots[2].top, 40.0 / 540.0);  // the numbers of the one, the label of the other
}

TEST(Slide, NamesTheXAxisOnceInAColumn) {
  Figure figure("columns", "Two rows", "time [s]");
  figure.slide(2);
  for (int i = 0; i < 4; ++i) figure.panel("position [m]").line("", times, times);
  EXPECT_EQ(countOf(figureText(figure).script, "'time [s]'"), 2U);

  Figure different("columns", "Two rows", "time [s]");
  different.slide(2);
  for (int i = 0; i < 4; ++i) different.panel("position [m]").line("", times, times).xLabel(i == 1 ? "step [s]" : "");
  const std::string script = figureText(different).script;
  EXPECT_EQ(countOf(script, "'time [s]'"), 2U);
  EXPECT_EQ(countOf(script, "'step [s]'"), 1U);
}

std::string bigEndian(unsigned number) {
  return {static_cast<char>(number >> 24U), static_cast<char>(number >> 16U), static_cast<char>(number >> 8U),
          static_cast<char>(number)};
}

TEST(SlideFiles, AreWholeInEveryFormat) {
  const TemporaryFolder folder(::testing::TempDir());
  writeFigures({crowded(3)}, folder.path(), {Format::Svg, Format::Pdf, Format::Png});
  EXPECT_EQ(namesIn(folder.path()),
            (std::vector<std::string>{"crowded.dat", "crowded.gp", "crowded.pdf", "crowded.png", "crowded.svg"}));
  const std::string png = readFile(folder.path() / "crowded.png");
  ASSERT_GT(png.size(), 1000U);
  EXPECT_EQ(png.substr(1, 3), "PNG");
  EXPECT_EQ(png.substr(12, 4), "IHDR");
  EXPECT_EQ(png.substr(16, 8), bigEndian(1280) + bigEndian(720));
  EXPECT_EQ(png.substr(png.size() - 8, 4), "IEND");
  const std::string pdf = readFile(folder.path() / "crowded.pdf");
  EXPECT_EQ(pdf.substr(0, 5), "%PDF-");
  EXPECT_TRUE(contains(pdf.substr(pdf.size() - 16), "%%EOF"));
  const std::string svg = readFile(folder.path() / "crowded.svg");
  EXPECT_TRUE(contains(svg, "viewBox=\"0 0 960 540\""));
  for (const char* text : {"A slide with everything on it", "a heading of some length", "implicit midpoint",
                           "symplectic Euler", "a long name of a hard case", "energy [J]"}) {
    EXPECT_TRUE(contains(svg, text)) << text;
  }
}

TEST(SlideData, HoldsArrowsCellsAndFields) {
  Figure figure("data", "What a slide can draw", "x [m]");
  figure.slide(3);
  figure.panel("z [m]").arrows("force", {0, 1}, {2, 3}, {0.5, NAN}, {-0.25, 1});
  figure.panel("case").cells("passed", {0, 1}, {1, 0});
  figure.panel("z [m]").field({{0, 1}, {5, 6, 7}, {1, 2, 3, NAN, 5, 6}, "energy [J]"});
  const FigureText text = figureText(figure);
  EXPECT_TRUE(contains(text.data, "\n0 2 0.5 -0.25\n\n")) << text.data;
  EXPECT_FALSE(contains(text.data, "1 3 "));  // an arrow with a component that is not a number
  EXPECT_TRUE(contains(text.data, "\n0 1\n1 0\n")) << text.data;
  EXPECT_TRUE(contains(text.data, "\n0 5 1\n1 5 2\n\n0 6 3\n1 6 NaN\n\n0 7 5\n1 7 6\n")) << text.data;
  EXPECT_TRUE(contains(text.script, "with vectors"));
  EXPECT_TRUE(contains(text.script, "with boxxyerror"));
  EXPECT_TRUE(contains(text.script, "with image"));
}

TEST(SlideAxes, EndWhereTheyAreTold) {
  Figure figure("ranges", "Fixed ranges", "time [s]");
  figure.slide(2);
  figure.panel("x [m]").line("", times, times).xRange(-1, 7).yRange(0.5, 2.5);
  figure.panel("x [m]").line("", times, times).field({{0, 1}, {0, 1}, {1, 2, 3, 4}, "E", {{-3, 9}}});
  const std::string script = figureText(figure).script;
  EXPECT_TRUE(contains(script, "set xrange [-1:7]\nset yrange [0.5:2.5]"));
  EXPECT_TRUE(contains(script, "set cbrange [-3:9]"));
}

TEST(SlideField, SaysOnItsScaleWhereTheColoursAreCut) {
  const auto scriptOf = [](std::vector<double> values, FixedRange range) {
    Figure figure("cut", "Cut", "x [m]");
    figure.slide().panel("z [m]").field({{0, 1}, {0, 1}, std::move(values), "E [J]", range, 10});
    return figureText(figure).script;
  };
  const std::string above = scriptOf({0, 1, 2, 60}, {{0, 50}});
  EXPECT_TRUE(contains(above, "set cbtics add ('≥50' 50)")) << above;
  EXPECT_TRUE(contains(above, "maxcolors 10 "));
  EXPECT_TRUE(contains(scriptOf({-7, NAN, 2, 60}, {{-5, 50}}), "set cbtics add ('≤-5' -5, '≥50' 50)"));
  // What reaches an end is not beyond it; without a range nothing is.
  EXPECT_FALSE(contains(scriptOf({0, 1, 2, 50}, {{0, 50}}), "cbtics add"));
  EXPECT_FALSE(contains(scriptOf({0, 1, 2, 60}, {}), "cbtics add"));
}

TEST(SlideField, HasLightLinesOnIt) {
  Figure figure("lines", "Lines", "x [m]");
  figure.slide(2);
  figure.panel("z [m]").structure("", {0, 1}, {0, 1});
  figure.panel("z [m]").structure("", {0, 1}, {0, 1}).field({{0, 1}, {0, 1}, {1, 2, 3, 4}, "E [J]"});
  const std::string script = figureText(figure).script;
  const std::size_t first = script.find("lc rgb '#ffffff' lw 1");
  ASSERT_NE(first, std::string::npos);
  EXPECT_GT(first, script.find("with image"));  // of the second panel only
  EXPECT_EQ(script.find("lc rgb '#ffffff' lw 1", first + 1), std::string::npos);
}

TEST(SlideNodes, AreDarkDiscsWhateverTheColoursAround) {
  Figure figure("nodes", "Nodes", "x [m]");
  figure.slide().panel("z [m]").line("spring", {0, 1}, {0, 1}).nodes("node", {0, 1}, {0, 1}).line("path", {0}, {1});
  const std::string script = figureText(figure).script;
  EXPECT_TRUE(contains(script, "set style line 22 lc rgb '#222222' lw 1 dt 1 pt 7"));
  EXPECT_TRUE(contains(script, "with points ls 22")) << script;
  EXPECT_FALSE(contains(script, "set style line 3 "));  // they take no colour of the palette
}

TEST(SlideAxes, MayBeLinearAfterALogarithmicOne) {
  Figure figure("scales", "Scales", "x");
  figure.slide(2).panel("y").line("", {1, 10}, {1, 10}).logX().logY();
  figure.panel("y").line("", {-1, 1}, {-1, 1});
  const std::string script = figureText(figure).script;
  // gnuplot cannot set a range with negative numbers on an axis that is still logarithmic.
  for (const char* axis : {"x", "y"}) {
    const std::size_t unset = script.rfind(std::string("unset logscale ") + axis);
    ASSERT_NE(unset, std::string::npos);
    EXPECT_LT(unset, script.find(std::string("set ") + axis + "range [-"));
  }
}

TEST(SlideAxes, HaveNumbersThatStandApart) {
  const AxisRange range{-0.25, 0.75};
  EXPECT_DOUBLE_EQ(ticStep(range, 100, 25), 0.5);
  EXPECT_DOUBLE_EQ(ticStep(range, 100, 20), 0.2);
  EXPECT_DOUBLE_EQ(ticStep(range, 1000, 1), 0.001);
  EXPECT_DOUBLE_EQ(ticStep({0, 6e5}, 100, 100), 1e6);
  EXPECT_EQ(widestNumber(range, 0.5), 3U);   // 0, 0.5
  EXPECT_EQ(widestNumber(range, 0.25), 5U);  // -0.25
  EXPECT_EQ(widestNumber({0, 6e5}, 1e5), 6U);
}

TEST(SlideCurves, TakeTheColourTheyAreGiven) {
  Figure figure("colours", "One thing, one colour", "x");
  figure.slide(2);
  figure.panel("y").line("a", times, times).line("b", times, times).colour(4).line("c", times, times);
  const std::string script = figureText(figure).script;
  EXPECT_TRUE(contains(script, "index 0 using 1:2 with lines ls 1,"));
  EXPECT_TRUE(contains(script, "index 1 using 1:2 with lines ls 5,"));
  EXPECT_TRUE(contains(script, "index 2 using 1:2 with lines ls 2\n"));
  EXPECT_TRUE(contains(script, "set style line 5 "));
}

TEST(SlideNotes, HaveTheColourOfTheCurveThatTheyName) {
  Figure figure("names", "Names at curves", "x");
  figure.slide();
  auto panel = figure.panel("y");
  panel.line("a", times, times).nameAt(1, 2, "first");
  panel.reference("exact", times, times).nameAt(1, 3, "dashed", true);
  panel.linePoints("", times, times).colour(4).nameAt(1, 4, "fifth").note(1, 5, "none");
  const std::string script = figureText(figure).script;
  const std::string place = " left offset character 0.7,0 front noenhanced font ',16' textcolor ";
  EXPECT_TRUE(contains(script, "set label 'first' at 1,2" + place + "ls 1\n")) << script;
  EXPECT_TRUE(contains(script, "set label 'fifth' at 1,4" + place + "ls 5\n"));
  EXPECT_TRUE(contains(script, "set label 'none' at 1,5" + place + "rgb '#111111'\n"));
  EXPECT_TRUE(
      contains(script, "set label 'dashed' at 1,3 center front noenhanced font ',16' textcolor rgb '#6a6a6a'\n"));
  // The reference of another figure comes behind the curves and leaves their names alone.
  const std::string over = figureText(figure.over(figure)).script;
  EXPECT_TRUE(contains(over, "set label 'fifth' at 1,4" + place + "ls 5\n"));
}

TEST(SlideSlopes, AreTrianglesUnderAPowerLaw) {
  Figure figure("slopes", "Slopes", "h");
  figure.slide().panel("error").line("", {0.1, 1}, {1e-3, 1}).logX().logY().slope(0.125, 0.25, 2, 3, "p = 3");
  const Panel& panel = figure.panels()[0];
  const Series& triangle = panel.series[1];
  EXPECT_EQ(triangle.x, (Numbers{0.125, 0.25, 0.25, 0.125}));
  EXPECT_EQ(triangle.y, (Numbers{0.25, 0.25, 2, 0.25}));  // up by 2^3
  EXPECT_EQ(triangle.pen, Pen::Structure);
  ASSERT_EQ(panel.notes.size(), 1U);
  EXPECT_EQ(panel.notes[0].text, "p = 3");
  EXPECT_DOUBLE_EQ(panel.notes[0].x, 0.25);
  EXPECT_DOUBLE_EQ(panel.notes[0].y, std::sqrt(0.25 * 2));  // halfway up, as the axis shows it
}

TEST(SlidePaths, LeaveThePictureAtNoPlaceOfTheirAxis) {
  Figure figure("spiral", "A spiral", "x [m]");
  figure.slide().panel("v [m/s]").equalAxes().line("out", {0, 1, 9}, {1, 0, 0}).expectX(-1, 1);
  EXPECT_TRUE(contains(figureText(figure).script, "'out (leaves the picture)'"));  // x is not a time
}

TEST(SlideErrors, AreFoundWhereTheyAreMade) {
  Figure figure("errors", "Mistakes", "x");
  EXPECT_THROW(figure.slide(0), std::invalid_argument);
  auto panel = figure.panel("y");
  EXPECT_THROW(panel.colour(1), std::invalid_argument);
  EXPECT_THROW(panel.nameAt(0, 0, "a"), std::invalid_argument);
  EXPECT_THROW(panel.slope(0, 1, 2, 1, "p = 1"), std::invalid_argument);
  EXPECT_THROW(panel.slope(1, 1, 1, 1, "p = 1"), std::invalid_argument);
  EXPECT_THROW(panel.slope(1, 1, 2, NAN, "p"), std::invalid_argument);
  EXPECT_THROW(panel.arrows("a", {1, 2}, {1, 2}, {1}, {1, 2}), std::invalid_argument);
  EXPECT_THROW(panel.xRange(1, 1), std::invalid_argument);
  EXPECT_THROW(panel.yRange(2, 1), std::invalid_argument);
  EXPECT_THROW(panel.yRange(NAN, 1), std::invalid_argument);
  EXPECT_THROW(panel.xRange(0, HUGE_VAL), std::invalid_argument);
  EXPECT_THROW(panel.field({{0, 1}, {0, 1}, {1, 2, 3}, "E"}), std::invalid_argument);
  EXPECT_THROW(panel.field({{0}, {0, 1}, {1, 2}, "E"}), std::invalid_argument);
  EXPECT_THROW(panel.field({{0, 1, 3}, {0, 1}, {1, 2, 3, 4, 5, 6}, "E"}), std::invalid_argument);
  EXPECT_THROW(panel.field({{0, 1}, {1, 0}, {1, 2, 3, 4}, "E"}), std::invalid_argument);
  EXPECT_THROW(panel.field({{0, 1}, {0, 1}, {1, 2, 3, 4}, "E", {{1, 0}}}), std::invalid_argument);
  EXPECT_THROW(panel.field({{0, 1}, {0, 1}, {1, 2, 3, 4}, "E", {}, 1}), std::invalid_argument);
}

TEST(SlideErrors, IncludeTextThatCannotBeSeen) {
  Figure figure("text", "Text", "x");
  auto panel = figure.panel("y");
  for (const std::string bad : {"a\nset output", "tab\t", "\x1b[31m", "\xff"}) {
    EXPECT_THROW(panel.heading(bad), std::invalid_argument) << bad;
    EXPECT_THROW(panel.xLabel(bad), std::invalid_argument) << bad;
    EXPECT_THROW(panel.note(0, 0, bad), std::invalid_argument) << bad;
    EXPECT_THROW(panel.xNames({"a", bad}), std::invalid_argument) << bad;
    EXPECT_THROW(panel.yNames({bad}), std::invalid_argument) << bad;
    EXPECT_THROW(panel.linePoints(bad, times, times), std::invalid_argument) << bad;
    EXPECT_THROW(panel.cells(bad, times, times), std::invalid_argument) << bad;
    EXPECT_THROW(panel.arrows(bad, times, times, times, times), std::invalid_argument) << bad;
    EXPECT_THROW(panel.field({{0, 1}, {0, 1}, {1, 2, 3, 4}, bad}), std::invalid_argument) << bad;
  }
}

}  // namespace
}  // namespace muelle
