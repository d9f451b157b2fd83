#include "base/file.h"
#include "figures/script.h"
#include "figures/write.h"
#include "support/lines.h"
#include "support/temporary.h"

#include <gtest/gtest.h>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <regex>
#include <sstream>

namespace muelle {
namespace {

using Numbers = std::vector<double>;
const Numbers t = {0, 1, 2, 3};

Figure example() {
  Figure figure("spring_1", "A spring's swing: x^2 -> E", "time [s]");
  figure.panel("position [m]").line("simulated", t, {1, 0, -1, 0}).reference("analytic", t, {1, 0.1, -1, 0.1});
  figure.panel("energy [J]").line("total", t, {2, 2, 2, 2}).points("measured", {1.5}, {2});
  return figure;
}

/// What stands in the single quotes of a script.
std::string withoutStrings(const std::string& script) {
  return std::regex_replace(script, std::regex("'[^'\n]*'"), "''");
}

/// Low and high of each "set yrange [low:high]".
std::vector<std::pair<double, double>> yRanges(const std::string& script) {
  std::vector<std::pair<double, double>> ranges;
  const std::regex pattern(R"(set yrange \[([^:]+):([^\]]+)\])");
  for (std::sregex_iterator it(script.begin(), script.end(), pattern), end; it != end; ++it) {
    ranges.emplace_back(std::stod((*it)[1]), std::stod((*it)[2]));
  }
  return ranges;
}

TEST(FigureScript, HoldsOnlyThePlot) {
  const std::string script = figureText(example()).script;
  const std::regex allowed("(#.*|reset|set .*|unset .*|plot .*| +''.*|)");
  for (const std::string& line : linesOf(withoutStrings(script))) {
    EXPECT_TRUE(std::regex_match(line, allowed)) << line;
    EXPECT_EQ(line.find_first_of("`!$\"|<>@"), std::string::npos) << line;
  }
}

TEST(FigureScript, ReadsAndWritesOnlyItsOwnFiles) {
  const std::string script = figureText(example()).script;
  const std::regex quotedFile("'[^']*\\.(dat|svg|gp)'");
  for (std::sregex_iterator it(script.begin(), script.end(), quotedFile), end; it != end; ++it) {
    EXPECT_TRUE(it->str() == "'spring_1.dat'" || it->str() == "'spring_1.svg'") << it->str();
  }
  EXPECT_EQ(countOf(script, "plot 'spring_1.dat'"), 2u);
}

TEST(FigureScript, DrawsReferencesUnderneath) {
  const std::string script = figureText(example()).script;
  EXPECT_LT(script.find("index 1 using 1:2 with lines ls 20"), script.find("index 0 using 1:2 with lines ls 1"));
}

// Within single quotes gnuplot knows one sign alone, the quote itself, which is doubled; the labels are not "enhanced".
TEST(FigureScript, HoldsTextAsItIsWritten) {
  const std::string script = figureText(example()).script;
  EXPECT_NE(script.find("A spring''s swing: x^2 -> E"), std::string::npos);
}

TEST(FigureScript, GivesAConstantCurveARange) {
  for (const double value : {0.0, 2.0, -3e-7, 1e99}) {
    Figure figure("constant", "Nothing happens", "time [s]");
    figure.panel("energy [J]").line("total", t, Numbers(4, value));
    const auto ranges = yRanges(figureText(figure).script);
    ASSERT_EQ(ranges.size(), 1u);
    EXPECT_LT(ranges[0].first, value);
    EXPECT_GT(ranges[0].second, value);
  }
}

TEST(FigureScript, GivesEqualAxesOneScale) {
  Figure figure("path", "A path", "x [m]");
  figure.equalAxes().panel("z [m]").line("path", {0, 3}, {0, 1});
  const std::string script = figureText(figure).script;
  const auto numbers = [&script](const char* pattern) {
    std::smatch match;
    std::regex_search(script, match, std::regex(pattern));
    return std::stod(match[2]) - std::stod(match[1]);
  };
  const double width = numbers(R"(set lmargin at screen (\S+); set rmargin at screen (\S+))");
  const double height = -numbers(R"(set tmargin at screen (\S+); set bmargin at screen (\S+))");
  std::smatch size;
  ASSERT_TRUE(std::regex_search(script, size, std::regex(R"(svg size (\d+),(\d+))")));
  const double perPixelX = numbers(R"(set xrange \[([^:]+):([^\]]+)\])") / (width * std::stod(size[1]));
  const double perPixelY = numbers(R"(set yrange \[([^:]+):([^\]]+)\])") / (height * std::stod(size[2]));
  EXPECT_NEAR(perPixelX / perPixelY, 1.0, 1e-3);  // five digits of the margins
}

TEST(FigureFiles, AreThreeAndCanBeDrawnAgainByHand) {
  const TemporaryFolder folder(::testing::TempDir());
  writeFigure(example(), folder.path() / "new" / "folder");
  const std::filesystem::path where = folder.path() / "new" / "folder";
  EXPECT_EQ(namesIn(where), (std::vector<std::string>{"spring_1.dat", "spring_1.gp", "spring_1.svg"}));
  const std::string svg = readFile(where / "spring_1.svg");
  EXPECT_NE(svg.find("A spring's swing: x^2 -> E"), std::string::npos);
  EXPECT_NE(svg.find("energy [J]"), std::string::npos);
  std::filesystem::remove(where / "spring_1.svg");
  ASSERT_EQ(std::system(("cd '" + where.string() + "' && gnuplot spring_1.gp").c_str()), 0);
  EXPECT_TRUE(readFile(where / "spring_1.svg") == svg);
}

/// Without the groups that draw nothing: gnuplot opens one more or less for the pen that the figure before has left.
std::string visibleIn(const std::string& svg) {
  return std::regex_replace(svg, std::regex("<g fill=\"none\"[^>]*>\\s*</g>\\s*"), "");
}

TEST(FigureFiles, OfSeveralFiguresAreTheSameAsOneByOne) {
  const TemporaryFolder together(::testing::TempDir());
  const TemporaryFolder alone(::testing::TempDir());
  Figure second("second", "Errors fall with the step", "step [s]");
  second.logX().panel("error [m]").logY().points("measured", {0.1, 0.01}, {1e-3, 1e-4});
  writeFigures({second, example()}, together.path());
  writeFigure(example(), alone.path());
  for (const char* name : {"spring_1.dat", "spring_1.gp", "spring_1.svg"}) {
    EXPECT_TRUE(visibleIn(readFile(together.path() / name)) == visibleIn(readFile(alone.path() / name))) << name;
  }
  EXPECT_EQ(namesIn(together.path()).size(), 6u);
  EXPECT_THROW(writeFigures({second, second}, together.path()), std::invalid_argument);
}

TEST(FigureFiles, AreNotLeftHalfWritten) {
  const TemporaryFolder folder(::testing::TempDir());
  writeFile(folder.path() / "file", "in the way");
  EXPECT_THROW(writeFigure(example(), folder.path() / "file"), std::runtime_error);
  const std::string path = std::getenv("PATH");
  setenv("PATH", "/nowhere", 1);
  EXPECT_THROW(writeFigure(example(), folder.path()), std::runtime_error);
  setenv("PATH", path.c_str(), 1);
  EXPECT_EQ(namesIn(folder.path()), std::vector<std::string>{"file"});
}

TEST(FigureGaps, AreMadeOfNumbersThatCannotBeDrawn) {
  const TemporaryFolder folder(::testing::TempDir());
  Figure figure("gaps", "Some numbers are missing", "time [s]");
  const double inf = std::numeric_limits<double>::infinity();
  figure.panel("position [m]").line("broken", {0, 1, 2, 3, 4, 5}, {0, 1, NAN, inf, 4, 1e200}).line("whole", t, t);
  writeFigure(figure, folder.path());
  const std::string data = readFile(folder.path() / "gaps.dat");
  EXPECT_NE(data.find("0 0\n1 1\n\n4 4\n\n\n# block 1"), std::string::npos) << data;
  EXPECT_EQ(data.find("nan"), std::string::npos);
  EXPECT_EQ(data.find("inf"), std::string::npos);
  const auto ranges = yRanges(readFile(folder.path() / "gaps.gp"));
  EXPECT_LT(ranges.at(0).second, 5.0);
}

TEST(FigureGaps, CanBeAllThereIs) {
  const TemporaryFolder folder(::testing::TempDir());
  Figure figure("empty", "No number at all", "time [s]");
  figure.panel("position [m]").line("simulated", t, Numbers(4, NAN)).reference("analytic", t, t);
  figure.panel("energy [J]").line("total", t, Numbers(4, HUGE_VAL));
  figure.panel("momentum [kg m/s]").line("none", {}, {});
  figure.panel("nothing");
  figure.panel("error [m]").logY().line("negative", t, Numbers(4, -1.0));
  writeFigure(figure, folder.path());
  const std::string svg = readFile(folder.path() / "empty.svg");
  EXPECT_NE(svg.find("simulated (no data)"), std::string::npos);
  EXPECT_GE(countOf(svg, ">no data<"), 4u);
}

// A curve that diverges does not flatten the others; one that is right but for rounding never "leaves".
TEST(FigureOverAReference, CutsWhatDivergesAndSaysWhere) {
  const Numbers times = {0.0, 1.0, 2.0, 3.0};
  const auto drawn = [&times](const std::string& unit, Numbers values) {
    Figure figure("f", "A title", "time [s]");
    figure.panel(unit).line("curve", times, std::move(values));
    return figure;
  };
  const std::string diverging =
      figureText(drawn("x [m]", {0.0, 2.0, 40.0, 900.0}).over(drawn("x [m]", {0, 1, 0, -1}))).script;
  EXPECT_NE(diverging.find("leaves the picture at t = 2 s"), std::string::npos);
  const auto ranges = yRanges(diverging);
  ASSERT_EQ(ranges.size(), 1u);
  EXPECT_LE(ranges[0].second, 8.0);
  const std::string rounding =
      figureText(drawn("p [kg m/s]", {0.0, 3e-16, -9e-16, 2e-15}).over(drawn("p [kg m/s]", {0, 1e-16, 0, -1e-16})))
          .script;
  EXPECT_EQ(rounding.find("leaves"), std::string::npos);
  const std::string drift =
      figureText(drawn("E [J]", {2.0, 2.00001, 1.99998, 2.00005}).over(drawn("E [J]", {2, 2.000001, 2, 2}))).script;
  EXPECT_EQ(drift.find("leaves"), std::string::npos);
}

// A run that explodes with changing signs passes through the picture again and again; markers draw no strokes.
TEST(FigureOverAReference, EndsALineWhereItLeavesThePicture) {
  const Numbers times = {0.0, 1.0, 2.0, 3.0, 4.0}, values = {0.0, 0.5, -40.0, 0.25, 900.0};
  Figure reference("f", "A title", "time [s]");
  reference.panel("x [m]").line("curve", times, {0, 1, 0, -1, 0});
  Figure figure("f", "A title", "time [s]");
  figure.panel("x [m]").line("curve", times, values);
  const std::string line = figureText(figure.over(reference)).data;
  EXPECT_NE(line.find("\n1 0.5\n2 -40\n"), std::string::npos) << line;
  EXPECT_EQ(line.find("\n3 0.25\n"), std::string::npos) << line;
  EXPECT_EQ(line.find("\n4 900\n"), std::string::npos) << line;
  EXPECT_NE(line.find("\n3 -1\n4 0\n"), std::string::npos) << "the reference goes on:\n" << line;
  Figure dots("f", "A title", "time [s]");
  dots.panel("x [m]").points("curve", times, values);
  EXPECT_NE(figureText(dots.over(reference)).data.find("\n3 0.25\n"), std::string::npos);
}

// What gnuplot, a shell or a format would take for more than text, and accents, Greek, powers and signs.
TEST(FigureText, IsDrawnAsItIsWritten) {
  const TemporaryFolder folder(::testing::TempDir());
  const std::string text = "`date` \"b\" \\n $x a@b {/Bold c}_d^2 caf\u00e9 50 % it's #~; \u03c9\u2081 \u2212 m\u00b2";
  Figure figure("id", text, text);
  figure.panel(text).line(text, t, t).reference("it's", t, t);
  writeFigure(figure, folder.path());
  EXPECT_EQ(countOf(readFile(folder.path() / "id.svg"), text), 4u);
}

TEST(FigureText, IsRefusedWhenItCannotBeSeen) {
  for (const std::string bad : {"a\nset output", "tab\t", "\x1b[31m", "\xff", "a\u202eb"}) {
    EXPECT_THROW(Figure("id", bad, "x"), std::invalid_argument) << bad;
    EXPECT_THROW(Figure("id", "title", bad), std::invalid_argument) << bad;
    Figure figure("id", "title", "x");
    EXPECT_THROW(figure.panel(bad), std::invalid_argument) << bad;
    EXPECT_THROW(figure.panel("y").line(bad, t, t), std::invalid_argument) << bad;
    EXPECT_THROW(figure.panel("y").reference(bad, t, t), std::invalid_argument) << bad;
    EXPECT_THROW(figure.panel("y").points(bad, t, t), std::invalid_argument) << bad;
  }
  EXPECT_THROW(Figure("id", std::string("a\0b", 3), "x"), std::invalid_argument);
  EXPECT_THROW(Figure("id", std::string(201, 'a'), "x"), std::invalid_argument);
  for (const std::string bad : {"", "../a", "a/b", "a b", "a.b", "a'b", "-a", "a\n"}) {
    EXPECT_THROW(Figure(bad, "title", "x"), std::invalid_argument) << bad;
  }
}

TEST(FigureText, IsNeverACommand) {
  const TemporaryFolder folder(::testing::TempDir());
  const std::string hostile = "x'; system('touch pwned'); print '| touch pwned ! <a>^2'";
  Figure figure("plain", hostile, hostile);
  figure.panel(hostile).line(hostile, t, t).reference(hostile, t, Numbers(4, NAN));
  writeFigure(figure, folder.path());
  EXPECT_EQ(namesIn(folder.path()).size(), 3u);
  EXPECT_NE(readFile(folder.path() / "plain.svg").find("touch pwned"), std::string::npos);
  EXPECT_NE(readFile(folder.path() / "plain.svg").find("&lt;a"), std::string::npos);
}

TEST(FigureCurves, NeedAnXForEachY) {
  Figure figure("id", "title", "x");
  EXPECT_THROW(figure.panel("y").line("a", {1, 2}, {1}), std::invalid_argument);
}

TEST(FigureCurves, GoToTheirOwnPanelInAnyOrder) {
  Figure figure("id", "title", "x");
  auto first = figure.panel("first");
  auto second = figure.panel("second");
  second.line("b", t, t);
  first.line("a", t, t);
  EXPECT_EQ(figure.panels()[0].series[0].name, "a");
  EXPECT_EQ(figure.panels()[1].series[0].name, "b");
}

TEST(FigureOver, PutsTheCurvesOfTheReferenceUnderneath) {
  Figure oracle("other", "another title", "x");
  oracle.panel("y").line("simulated", t, {1, 2, 3, 4}).reference("analytic", t, t);
  oracle.panel("y").line("kinetic", t, t).points("elastic", t, t);
  const Figure both = example().over(oracle);
  EXPECT_EQ(both.id(), "spring_1");
  EXPECT_EQ(both.title(), example().title());
  const std::vector<Series>& first = both.panels()[0].series;
  ASSERT_EQ(first.size(), 3u);  // the analytic curve is not drawn twice
  EXPECT_EQ(first[2].name, "reference: simulated");
  EXPECT_EQ(first[2].pen, Pen::Reference);
  EXPECT_EQ(first[2].y, (Numbers{1, 2, 3, 4}));
  const std::vector<Series>& second = both.panels()[1].series;
  ASSERT_EQ(second.size(), 4u);
  EXPECT_EQ(second[2].name, "reference");
  EXPECT_EQ(second[3].name, "");
}

TEST(FigureOver, MarkersAboveEachOtherHaveNoReferenceLine) {
  Figure figure("column", "A column", "time [s]");
  figure.panel("height [m]").points("at rest", {4, 4, 4}, {0.1, 0.2, 0.3}).points("falling", {1, 2, 3}, {3, 2, 1});
  const Figure both = figure.over(figure);
  ASSERT_EQ(both.panels()[0].series.size(), 3U);
  EXPECT_EQ(both.panels()[0].series.back().name, "reference: falling");
}

TEST(FigureOver, RefusesAFigureOfOtherPanels) {
  EXPECT_THROW(example().over(Figure("id", "title", "x")), std::invalid_argument);
}

}  // namespace
}  // namespace muelle
