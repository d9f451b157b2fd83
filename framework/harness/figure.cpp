#include "harness/figure.h"

#include "base/text/utf8.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>
#include <utility>

namespace muelle {

namespace {

bool isLetterOrDigit(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9'); }

/// What is drawn stands on one line and is seen: no line break, which would end a line of the script, nothing hidden.
void requireDrawable(const char* what, std::string_view text) {
  int characters = 0;
  for (std::size_t at = 0; at < text.size(); ++characters) {
    const CodePoint next = decodeUtf8(text.substr(at));
    if (!next.valid || isTreacherous(next.value)) {
      throw std::invalid_argument(
          fmt::format("Figure: the {} has at byte {} what cannot be drawn (0x{:02x}); printable text in UTF-8 can be",
                      what, at, static_cast<unsigned char>(text[at])));
    }
    at += next.length;
  }
  if (characters <= longestFigureText) return;
  throw std::invalid_argument(fmt::format("Figure: the {} is longer than {} characters", what, longestFigureText));
}

void requireId(const std::string& id) {
  constexpr std::size_t longest = 100;
  const auto allowed = [](char c) { return isLetterOrDigit(c) || c == '_'; };
  if (!id.empty() && id.size() <= longest && std::all_of(id.begin(), id.end(), allowed)) return;
  throw std::invalid_argument(
      fmt::format("Figure: an id is 1 to {} letters, digits and _, because it names the files", longest));
}

}  // namespace

Figure::Figure(std::string id, std::string title, std::string xLabel)
    : id_(std::move(id)), title_(std::move(title)), xLabel_(std::move(xLabel)) {
  requireId(id_);
  requireDrawable("title", title_);
  requireDrawable("label of the x axis", xLabel_);
}

Figure::PanelBuilder Figure::panel(std::string yLabel) {
  requireDrawable("label of a y axis", yLabel);
  panels_.push_back({std::move(yLabel), {}});
  return {*this, panels_.size() - 1};
}

Figure& Figure::slide(int columns) {
  if (columns < 1) throw std::invalid_argument(fmt::format("Figure '{}': a slide has columns, not {}", id_, columns));
  columns_ = columns;
  return *this;
}

Figure& Figure::equalAxes() {
  equalAxes_ = true;
  return *this;
}

Figure& Figure::logX() {
  logX_ = true;
  return *this;
}

Figure::PanelBuilder& Figure::PanelBuilder::add(Series series) {
  requireDrawable("name of a curve", series.name);
  if (series.x.size() != series.y.size()) {
    throw std::invalid_argument(
        fmt::format("Figure: the curve '{}' has {} x and {} y", series.name, series.x.size(), series.y.size()));
  }
  if (series.pen == Pen::Arrows && (series.dx.size() != series.x.size() || series.dy.size() != series.x.size())) {
    throw std::invalid_argument(fmt::format("Figure: the arrows '{}' have {} feet and {} dx, {} dy", series.name,
                                            series.x.size(), series.dx.size(), series.dy.size()));
  }
  panel().series.push_back(std::move(series));
  return *this;
}

Figure::PanelBuilder& Figure::PanelBuilder::line(std::string name, std::vector<double> x, std::vector<double> y) {
  return add({std::move(name), std::move(x), std::move(y), Pen::Line});
}

Figure::PanelBuilder& Figure::PanelBuilder::reference(std::string name, std::vector<double> x, std::vector<double> y) {
  return add({std::move(name), std::move(x), std::move(y), Pen::Reference});
}

Figure::PanelBuilder& Figure::PanelBuilder::points(std::string name, std::vector<double> x, std::vector<double> y) {
  return add({std::move(name), std::move(x), std::move(y), Pen::Points});
}

Figure::PanelBuilder& Figure::PanelBuilder::linePoints(std::string name, std::vector<double> x, std::vector<double> y) {
  return add({std::move(name), std::move(x), std::move(y), Pen::LinePoints});
}

Figure::PanelBuilder& Figure::PanelBuilder::arrows(std::string name, std::vector<double> x, std::vector<double> y,
                                                   std::vector<double> dx, std::vector<double> dy) {
  return add({std::move(name), std::move(x), std::move(y), Pen::Arrows, std::move(dx), std::move(dy)});
}

Figure::PanelBuilder& Figure::PanelBuilder::cells(std::string name, std::vector<double> x, std::vector<double> y) {
  return add({std::move(name), std::move(x), std::move(y), Pen::Cells});
}

Figure::PanelBuilder& Figure::PanelBuilder::mesh(std::string name, std::vector<double> x, std::vector<double> y) {
  return add({std::move(name), std::move(x), std::move(y), Pen::Mesh});
}

Figure::PanelBuilder& Figure::PanelBuilder::structure(std::string name, std::vector<double> x, std::vector<double> y) {
  return add({std::move(name), std::move(x), std::move(y), Pen::Structure});
}

Figure::PanelBuilder& Figure::PanelBuilder::nodes(std::string name, std::vector<double> x, std::vector<double> y) {
  return add({std::move(name), std::move(x), std::move(y), Pen::Nodes});
}

Figure::PanelBuilder& Figure::PanelBuilder::colour(int position) {
  if (panel().series.empty()) throw std::invalid_argument("Figure: colour() before any curve");
  panel().series.back().colour = position;
  return *this;
}

Figure::PanelBuilder& Figure::PanelBuilder::logY() {
  panel().logY = true;
  return *this;
}

Figure::PanelBuilder& Figure::PanelBuilder::logX() {
  panel().logX = true;
  return *this;
}

Figure::PanelBuilder& Figure::PanelBuilder::equalAxes() {
  panel().equalAxes = true;
  return *this;
}

Figure::PanelBuilder& Figure::PanelBuilder::heading(std::string text) {
  requireDrawable("heading", text);
  panel().heading = std::move(text);
  return *this;
}

Figure::PanelBuilder& Figure::PanelBuilder::xLabel(std::string text) {
  requireDrawable("label of an x axis", text);
  panel().xLabel = std::move(text);
  return *this;
}

namespace {

void requireRange(double low, double high) {
  if (low < high && std::isfinite(low) && std::isfinite(high)) return;
  throw std::invalid_argument(
      fmt::format("Figure: a range goes from a lower to a higher number, not {} to {}", low, high));
}

bool isEquallySpaced(const std::vector<double>& lines) {
  if (lines.size() < 2) return false;
  const double step = (lines.back() - lines.front()) / static_cast<double>(lines.size() - 1);
  for (std::size_t i = 1; i < lines.size(); ++i) {
    if (!(std::abs(lines[i] - lines[i - 1] - step) < 1e-6 * step)) return false;
  }
  return true;
}

}  // namespace

Figure::PanelBuilder& Figure::PanelBuilder::xRange(double low, double high) {
  requireRange(low, high);
  panel().xRange = {low, high};
  return *this;
}

Figure::PanelBuilder& Figure::PanelBuilder::yRange(double low, double high) {
  requireRange(low, high);
  panel().yRange = {low, high};
  return *this;
}

Figure::PanelBuilder& Figure::PanelBuilder::expect(double low, double high) {
  requireRange(low, high);
  panel().yExpected = {low, high};
  return *this;
}

Figure::PanelBuilder& Figure::PanelBuilder::expectX(double low, double high) {
  requireRange(low, high);
  panel().xExpected = {low, high};
  return *this;
}

Figure::PanelBuilder& Figure::PanelBuilder::note(double x, double y, std::string text, bool centred) {
  requireDrawable("note", text);
  panel().notes.push_back({x, y, std::move(text), centred});
  return *this;
}

Figure::PanelBuilder& Figure::PanelBuilder::nameAt(double x, double y, std::string text, bool centred) {
  if (panel().series.empty()) throw std::invalid_argument("Figure: nameAt() before any curve");
  note(x, y, std::move(text), centred);
  panel().notes.back().curve = static_cast<int>(panel().series.size()) - 1;
  return *this;
}

Figure::PanelBuilder& Figure::PanelBuilder::slope(double x, double y, double across, double power, std::string text) {
  if (!(x > 0.0 && y > 0.0 && across > 1.0 && power > 0.0)) {
    throw std::invalid_argument(fmt::format(
        "Figure: a slope rises to the right from a positive point, not from ({}, {}) by a factor {} to the power {}", x,
        y, across, power));
  }
  const double right = x * across, top = y * std::pow(across, power);
  structure("", {x, right, right, x}, {y, y, top, y});
  return note(right, std::sqrt(y * top), std::move(text));
}

Figure::PanelBuilder& Figure::PanelBuilder::field(Field field) {
  requireDrawable("label of the colours", field.label);
  if (!isEquallySpaced(field.x) || !isEquallySpaced(field.y)) {
    throw std::invalid_argument("Figure: the lines of a field's grid ascend by equal distances, at least two each way");
  }
  if (field.range) requireRange(field.range->first, field.range->second);
  if (field.bands < 2) throw std::invalid_argument("Figure: a field has at least two bands of colour");
  if (field.values.size() != field.x.size() * field.y.size()) {
    throw std::invalid_argument(
        fmt::format("Figure: {} values for a grid of {} by {}", field.values.size(), field.x.size(), field.y.size()));
  }
  panel().field = std::move(field);
  return *this;
}

Figure::PanelBuilder& Figure::PanelBuilder::xNames(std::vector<std::string> names) {
  for (const std::string& name : names) requireDrawable("name on an axis", name);
  panel().xNames = std::move(names);
  return *this;
}

Figure::PanelBuilder& Figure::PanelBuilder::yNames(std::vector<std::string> names) {
  for (const std::string& name : names) requireDrawable("name on an axis", name);
  panel().yNames = std::move(names);
  return *this;
}

namespace {

/// A reference is drawn as a line. Through markers it is one only where they go from left to right: markers above each
/// other, one a node, would be joined by a stroke that means nothing.
bool hasReferenceCurve(const Series& series) {
  return series.pen != Pen::Points || std::ranges::adjacent_find(series.x, std::greater_equal()) == series.x.end();
}

/// The ends of what the curves of a panel reach along one axis; from 0 on where they hardly change, and none where they
/// are 0 but for rounding: that has no size to measure others by.
FixedRange reachOf(const Panel& panel, std::vector<double> Series::*axis) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const Series& series : panel.series) {
    for (const double value : series.*axis) {
      if (!std::isfinite(value)) continue;
      low = std::min(low, value);
      high = std::max(high, value);
    }
  }
  constexpr double hardly = 1e-3, roundOff = 1e-12;
  const double size = std::max(std::abs(low), std::abs(high));
  if (!(size > roundOff)) return std::nullopt;
  if (high - low <= hardly * size) {
    low = std::min(low, 0.0);
    high = std::max(high, 0.0);
  }
  if (low < high && std::isfinite(high - low)) return std::pair(low, high);
  return std::nullopt;
}

}  // namespace

Figure Figure::withRemark(const std::string& remark) const {
  Figure remarked = *this;
  remarked.title_ += "; " + remark;
  requireDrawable("title", remarked.title_);
  return remarked;
}

Figure Figure::over(const Figure& reference) const {
  if (reference.panels_.size() != panels_.size()) {
    throw std::invalid_argument(
        fmt::format("Figure '{}': {} panels over a reference of {}", id_, panels_.size(), reference.panels_.size()));
  }
  Figure both = *this;
  for (std::size_t i = 0; i < panels_.size(); ++i) {
    std::vector<Series> under;
    for (const Series& series : reference.panels_[i].series) {
      if (series.pen != Pen::Reference && hasReferenceCurve(series)) under.push_back(series);
    }
    for (std::size_t j = 0; j < under.size(); ++j) {
      under[j].pen = Pen::Reference;
      under[j].name = under.size() == 1 ? "reference: " + under[j].name : (j == 0 ? "reference" : "");
    }
    both.panels_[i].yExpected = reachOf(reference.panels_[i], &Series::y);
    if (equalAxes_) both.panels_[i].xExpected = reachOf(reference.panels_[i], &Series::x);
    std::vector<Series>& series = both.panels_[i].series;
    series.insert(series.end(), under.begin(), under.end());
  }
  return both;
}

}  // namespace muelle
