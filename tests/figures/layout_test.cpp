#include "figures/layout.h"

#include <gtest/gtest.h>
#include <cmath>
#include <string>

namespace muelle::figures {
namespace {

/// A part of a figure and the room that it takes.
struct Part {
  std::string name;
  Box box;
};

void addPart(std::vector<Part>& parts, const std::string& name, const Label& label) {
  if (label.width > 0) parts.push_back({name, label.box()});
}

std::vector<Part> partsOf(const Layout& layout) {
  std::vector<Part> parts;
  addPart(parts, "title", layout.title);
  for (std::size_t i = 0; i < layout.panels.size(); ++i) {
    const PanelLayout& panel = layout.panels[i];
    const std::string of = " of panel " + std::to_string(i);
    parts.push_back({"plot" + of, panel.plot});
    addPart(parts, "y label" + of, panel.yLabel);
    for (const Label& entry : panel.key) addPart(parts, "entry of the key" + of, entry);
    if (panel.xLabel) addPart(parts, "x label" + of, *panel.xLabel);
    if (panel.heading) addPart(parts, "heading" + of, *panel.heading);
    if (panel.colourScale) parts.push_back({"colour scale" + of, *panel.colourScale});
    addPart(parts, "label of the colours" + of, panel.colourLabel);
  }
  return parts;
}

/// Text has more room than it takes, so a pixel is no overlap.
bool overlap(const Box& a, const Box& b) {
  constexpr double slack = 1;
  return a.left + slack < b.right && b.left + slack < a.right && a.top + slack < b.bottom && b.top + slack < a.bottom;
}

void expectApart(const Layout& layout) {
  const std::vector<Part> parts = partsOf(layout);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    for (std::size_t j = i + 1; j < parts.size(); ++j) {
      EXPECT_FALSE(overlap(parts[i].box, parts[j].box)) << parts[i].name << " and " << parts[j].name;
    }
  }
}

void expectOnPage(const Layout& layout) {
  for (const auto& [name, box] : partsOf(layout)) {
    EXPECT_GE(box.left, 0.0) << name;
    EXPECT_LE(box.right, layout.width) << name;
    EXPECT_GE(box.top, 0.0) << name;
    EXPECT_LE(box.bottom, layout.height) << name;
    EXPECT_LT(box.left, box.right) << name;
    EXPECT_LT(box.top, box.bottom) << name;
  }
}

/// Units of x in a pixel over units of y in a pixel.
double aspectOf(const PanelLayout& panel) {
  return (panel.x.span() / panel.plot.width()) / (panel.y.span() / panel.plot.height());
}

PanelShape panelWith(std::vector<double> key) {
  PanelShape shape;
  shape.x.range = {0, 10};
  shape.y.range = {-1, 1};
  shape.yLabel = 120;
  shape.key = std::move(key);
  return shape;
}

FigureShape stackOf(std::vector<PanelShape> panels) {
  panels.back().xLabel = 80;
  return {0, 20, std::move(panels)};
}

FigureShape slideOf(int columns, std::vector<PanelShape> panels) {
  for (PanelShape& panel : panels) panel.xLabel = 80;
  return {columns, 20, std::move(panels)};
}

/// All that takes room above, below and beside a plot, as much of it as a slide of three columns holds.
std::vector<PanelShape> crowded() {
  std::vector<PanelShape> panels(6, panelWith({98, 118}));
  for (PanelShape& panel : panels) panel.heading = 220;
  panels[1].y = {{1e-7, 100}, true};
  panels[2].equalAxes = true;
  panels[3].x.names = 118;
  panels[4].colours = 100;
  panels[4].key = {};
  panels[5].y.names = 200;
  return panels;
}

TEST(StackedLayout, HasTheSizesOfItsParts) {
  const Layout layout = layOut(stackOf({panelWith({100}), panelWith({})}));
  ASSERT_EQ(layout.panels.size(), 2U);
  EXPECT_DOUBLE_EQ(layout.width, 960);
  // Title, a row of labels and the gap below it, plot; gap between panels; row, gap, plot; foot.
  EXPECT_DOUBLE_EQ(layout.height, 50 + (26 + 12 + 196) + 16 + (26 + 12 + 196) + 72);
  EXPECT_DOUBLE_EQ(layout.panels[0].plot.top, 88);
  EXPECT_DOUBLE_EQ(layout.panels[1].plot.top, 88 + 196 + 16 + 38);
  EXPECT_FALSE(layout.panels[0].xLabel);
  ASSERT_TRUE(layout.panels[1].xLabel);
  EXPECT_DOUBLE_EQ(layout.panels[1].xLabel->x, (112 + 926) / 2.0);
  // One entry, flush right with the plot and on the label's line.
  ASSERT_EQ(layout.panels[0].key.size(), 1U);
  EXPECT_DOUBLE_EQ(layout.panels[0].key[0].box().right, 926);
  EXPECT_DOUBLE_EQ(layout.panels[0].key[0].y, layout.panels[0].yLabel.y);
}

TEST(StackedLayout, KeepsItsPartsApartAndOnThePage) {
  for (const std::size_t entries : {0U, 1U, 4U, 9U}) {
    const Layout layout = layOut(stackOf(std::vector<PanelShape>(3, panelWith(std::vector<double>(entries, 230.0)))));
    expectApart(layout);
    expectOnPage(layout);
  }
}

TEST(StackedLayout, GivesPlotsTheSameEdges) {
  const Layout layout = layOut(stackOf({panelWith({900}), panelWith({}), panelWith({200, 300, 400})}));
  for (const PanelLayout& panel : layout.panels) {
    EXPECT_DOUBLE_EQ(panel.plot.left, layout.panels[0].plot.left);
    EXPECT_DOUBLE_EQ(panel.plot.right, layout.panels[0].plot.right);
    EXPECT_DOUBLE_EQ(panel.plot.height(), layout.panels[0].plot.height());
  }
}

TEST(StackedLayout, KeepsOneScaleOnEqualAxes) {
  for (const double height : {0.01, 1.0, 100.0}) {
    PanelShape shape = panelWith({100});
    shape.equalAxes = true;
    shape.y.range = {0, height};
    const PanelLayout panel = layOut(stackOf({shape})).panels.front();
    EXPECT_NEAR(aspectOf(panel), 1.0, 1e-12) << height;
    EXPECT_GE(panel.plot.width(), 360.0 - 1e-9);
    EXPECT_LE(panel.x.low, 0.0);  // what was asked for is shown
    EXPECT_GE(panel.x.high, 10.0);
    EXPECT_LE(panel.y.low, 0.0);
    EXPECT_GE(panel.y.high, height);
  }
}

/// Equal scales make the plot of a high drawing slim: it begins where the first row of the key already runs.
TEST(Key, LeavesTheLabelOfASlimPlotItsRoom) {
  PanelShape shape = panelWith({371, 351});
  shape.equalAxes = true;
  shape.y.range = {0, 100};
  const PanelLayout panel = layOut(stackOf({shape})).panels.front();
  ASSERT_GT(panel.plot.left, panel.key.front().x);
  EXPECT_FALSE(overlap(panel.yLabel.box(), panel.key.front().box()));
  EXPECT_GE(panel.yLabel.x, 0.0);
}

TEST(Key, BreaksIntoRowsThatEndWithThePlot) {
  const PanelLayout panel = layOut(stackOf({panelWith({300, 300, 300, 200})})).panels.front();
  ASSERT_EQ(panel.key.size(), 4U);
  // 120 of the label and two entries fill the first row of 902.
  EXPECT_DOUBLE_EQ(panel.key[0].y, panel.yLabel.y);
  EXPECT_DOUBLE_EQ(panel.key[1].y, panel.yLabel.y);
  EXPECT_DOUBLE_EQ(panel.key[1].box().right, 926);
  EXPECT_DOUBLE_EQ(panel.key[1].x - panel.key[0].box().right, 20);
  EXPECT_DOUBLE_EQ(panel.key[2].y, panel.yLabel.y + 26);
  EXPECT_DOUBLE_EQ(panel.key[3].box().right, 926);
}

TEST(Key, FillsARowToTheLastPixel) {
  // 902 from the label's beginning to the plot's end, less 120 of the label and a gap of 20 behind each.
  const PanelLayout fits = layOut(stackOf({panelWith({371, 351})})).panels.front();
  EXPECT_DOUBLE_EQ(fits.key.at(1).y, fits.yLabel.y);
  const PanelLayout breaks = layOut(stackOf({panelWith({371, 352})})).panels.front();
  EXPECT_GT(breaks.key.at(1).y, breaks.yLabel.y);
}

TEST(Key, OfOneEntryARowHasOneBeginning) {
  const PanelLayout panel = layOut(stackOf({panelWith({500, 600, 700})})).panels.front();
  ASSERT_EQ(panel.key.size(), 3U);
  for (const Label& entry : panel.key) EXPECT_DOUBLE_EQ(entry.x, 926 - 700);
}

TEST(Key, ShowsTheBeginningOfANameWiderThanThePage) {
  const PanelLayout panel = layOut(stackOf({panelWith({2000})})).panels.front();
  ASSERT_EQ(panel.key.size(), 1U);
  EXPECT_DOUBLE_EQ(panel.key[0].x, panel.yLabel.x);
}

TEST(Title, IsSmallerWhenItIsLong) {
  FigureShape figure = stackOf({panelWith({})});
  EXPECT_DOUBLE_EQ(layOut(figure).titleSize, 21);
  figure.title = 80;
  const Layout layout = layOut(figure);
  EXPECT_DOUBLE_EQ(layout.titleSize, 11.5);
  EXPECT_LE(layout.title.box().right, layout.width);
}

TEST(SlideLayout, IsWideAndFilled) {
  const Layout layout = layOut(slideOf(2, {panelWith({}), panelWith({})}));
  EXPECT_DOUBLE_EQ(layout.width / layout.height, 16.0 / 9.0);
  const PanelLayout& left = layout.panels[0];
  const PanelLayout& right = layout.panels[1];
  EXPECT_DOUBLE_EQ(left.plot.top, 50 + 26 + 12);
  EXPECT_DOUBLE_EQ(left.plot.bottom, 540 - 66);
  EXPECT_DOUBLE_EQ(left.plot.right, 450);
  EXPECT_DOUBLE_EQ(right.plot.right, 926);
  EXPECT_DOUBLE_EQ(left.plot.width(), right.plot.width());
}

// Names are 13 px high. A table that fits is as high as every slide; a longer one is higher, and the rest stays as it
// is.
TEST(SlideLayout, GivesEachNameOfATableARowOfItsOwn) {
  PanelShape table = panelWith({});
  table.y.names = 80;
  const auto height = [&table](std::size_t rows) {
    table.y.rows = rows;
    const Layout layout = layOut(slideOf(1, {table}));
    const PanelLayout& panel = layout.panels[0];
    EXPECT_GE(panel.plot.height() / static_cast<double>(rows), 14.0) << rows;
    EXPECT_DOUBLE_EQ(panel.plot.top, 50 + 26 + 12) << rows;
    EXPECT_DOUBLE_EQ(panel.plot.bottom, layout.height - 66) << rows;
    return layout.height;
  };
  EXPECT_DOUBLE_EQ(height(10), 540);
  EXPECT_GT(height(40), 540);
}

TEST(SlideLayout, KeepsItsPartsApartAndOnThePage) {
  const Layout layout = layOut(slideOf(3, crowded()));
  expectApart(layout);
  expectOnPage(layout);
}

TEST(SlideLayout, GivesTheRowsOneHeight) {
  std::vector<PanelShape> panels(4, panelWith({}));
  panels[0].heading = 700;
  panels[2].key = std::vector<double>(5, 200.0);
  const Layout layout = layOut(slideOf(2, std::move(panels)));
  for (const std::size_t row : {0U, 2U}) {
    EXPECT_DOUBLE_EQ(layout.panels[row].plot.top, layout.panels[row + 1].plot.top);
    EXPECT_NEAR(layout.panels[row].plot.height(), layout.panels[0].plot.height(), 1e-9);
  }
}

TEST(SlideLayout, KeepsOneScaleOnEqualAxes) {
  for (const double height : {0.01, 2.0, 1000.0}) {
    for (const bool isField : {false, true}) {
      std::vector<PanelShape> panels(2, panelWith({100}));
      panels[1].equalAxes = true;
      panels[1].y.range = {0, height};
      if (isField) panels[1].colours = 100;
      const PanelLayout panel = layOut(slideOf(2, std::move(panels))).panels[1];
      EXPECT_NEAR(aspectOf(panel), 1.0, 1e-9) << height;
      if (isField) {
        EXPECT_DOUBLE_EQ(panel.x.span(), 10.0);  // a field fills its plot
      }
    }
  }
}

TEST(SlideLayout, ShrinksAHeadingIntoItsColumn) {
  for (const double width : {200.0, 500.0, 700.0}) {
    std::vector<PanelShape> panels(2, panelWith({100}));
    panels[0].heading = width;
    const PanelLayout panel = layOut(slideOf(2, std::move(panels))).panels[0];
    ASSERT_TRUE(panel.heading);
    EXPECT_GE(panel.heading->box().left, 0.0);
    EXPECT_LE(panel.heading->box().right, 450.0 + 1e-9);
    EXPECT_DOUBLE_EQ(panel.headingSize, std::min(18.0, 18 * 450 / width));
  }
}

TEST(SlideLayout, SetsAShortHeadingBesideTheLabel) {
  std::vector<PanelShape> panels(2, panelWith({}));
  panels[0].heading = 60;
  panels[0].yLabel = 40;
  const Layout layout = layOut(slideOf(2, panels));
  EXPECT_DOUBLE_EQ(layout.panels[0].heading->y, layout.panels[0].yLabel.y);
  panels[1].heading = 400;  // needs a line of its own, and so has its neighbour
  const Layout two = layOut(slideOf(2, panels));
  EXPECT_LT(two.panels[0].heading->y, two.panels[0].yLabel.y);
  EXPECT_DOUBLE_EQ(two.panels[0].heading->y, two.panels[1].heading->y);
}

TEST(SlideLayout, TurnsLongNamesAndGivesThemRoom) {
  PanelShape shape = panelWith({});
  shape.x.names = 29;
  const PanelLayout level = layOut(slideOf(1, {shape})).panels[0];
  shape.x.names = 150;
  const PanelLayout turned = layOut(slideOf(1, {shape})).panels[0];
  EXPECT_FALSE(level.turnsXNames);
  EXPECT_TRUE(turned.turnsXNames);
  EXPECT_DOUBLE_EQ(level.plot.bottom - turned.plot.bottom, 0.8 * 150 - 20);
}

TEST(SlideLayout, SetsNumbersApart) {
  PanelShape shape = panelWith({});
  shape.x.range = {0, 1e6};
  shape.y = {{1e-12, 1}, true};
  for (const int columns : {1, 3}) {
    const PanelLayout panel = layOut(slideOf(columns, std::vector<PanelShape>(3, shape))).panels[0];
    EXPECT_GE(panel.plot.width() * panel.xStep / panel.x.span(),
              10.0 * static_cast<double>(widestNumber(panel.x, panel.xStep)) + 16);
    EXPECT_GE(panel.plot.height() * std::log10(panel.yStep) / 12, 32.0 - 1e-9);
  }
}

TEST(Label, TakesARow) {
  EXPECT_DOUBLE_EQ((Label{100, 50, 40, Side::Left}).box().right, 140);
  EXPECT_DOUBLE_EQ((Label{100, 50, 40, Side::Centre}).box().left, 80);
  EXPECT_DOUBLE_EQ((Label{100, 50, 40, Side::Right}).box().left, 60);
  EXPECT_DOUBLE_EQ((Label{100, 50, 40, Side::Right}).box().height(), 26);
}

}  // namespace
}  // namespace muelle::figures
