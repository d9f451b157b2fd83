#include "harness/figure.h"

#include "harness/figure_script.h"
#include "harness/file.h"
#include "harness/gnuplot.h"

#include <fmt/format.h>
#include <algorithm>
#include <functional>
#include <set>
#include <stdexcept>
#include <utility>

namespace muelle {

namespace fs = std::filesystem;

namespace {

bool isLetterOrDigit(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9'); }

bool isPlain(char c) {
  return isLetterOrDigit(c) || std::string_view(" .,:;()[]/+-*=^_<>|%!?'").find(c) != std::string_view::npos;
}

/// gnuplot runs what stands in a script, so nothing but plain text may get there.
void requirePlain(const char* what, const std::string& text) {
  constexpr std::size_t longest = 200;
  if (text.size() > longest) {
    throw std::invalid_argument(fmt::format("Figure: the {} is longer than {} characters", what, longest));
  }
  const auto bad = std::find_if_not(text.begin(), text.end(), isPlain);
  if (bad == text.end()) return;
  throw std::invalid_argument(
      fmt::format("Figure: the {} has the character 0x{:02x} at position {}; letters, digits, blanks and "
                  ".,:;()[]/+-*=^_<>|%!?' are allowed",
                  what, static_cast<unsigned char>(*bad), bad - text.begin()));
}

void requireId(const std::string& id) {
  constexpr std::size_t longest = 100;
  const auto allowed = [](char c) { return isLetterOrDigit(c) || c == '_'; };
  if (!id.empty() && id.size() <= longest && std::all_of(id.begin(), id.end(), allowed)) return;
  throw std::invalid_argument(
      fmt::format("Figure: an id is 1 to {} letters, digits and _, because it names the files", longest));
}

/// gnuplot ends a file with this when it got to the end of the script.
bool isComplete(const std::string& svg) { return svg.find("</svg>") != std::string::npos; }

void publish(const fs::path& from, const fs::path& to) {
  std::error_code error;
  fs::rename(from, to, error);
  if (error) throw std::runtime_error(fmt::format("cannot write {}: {}", to.string(), error.message()));
}

}  // namespace

Figure::Figure(std::string id, std::string title, std::string xLabel)
    : id_(std::move(id)), title_(std::move(title)), xLabel_(std::move(xLabel)) {
  requireId(id_);
  requirePlain("title", title_);
  requirePlain("label of the x axis", xLabel_);
}

Figure::PanelBuilder Figure::panel(std::string yLabel) {
  requirePlain("label of a y axis", yLabel);
  panels_.push_back({std::move(yLabel), {}, false});
  return {*this, panels_.size() - 1};
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
  requirePlain("name of a curve", series.name);
  if (series.x.size() != series.y.size()) {
    throw std::invalid_argument(
        fmt::format("Figure: the curve '{}' has {} x and {} y", series.name, series.x.size(), series.y.size()));
  }
  figure_.panels_[index_].series.push_back(std::move(series));
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

Figure::PanelBuilder& Figure::PanelBuilder::logY() {
  figure_.panels_[index_].logY = true;
  return *this;
}

namespace {

/// A reference is drawn as a line. Through markers it is one only where they go from left to right: markers above each
/// other, one a node, would be joined by a stroke that means nothing.
bool hasReferenceCurve(const Series& series) {
  return series.pen != Pen::Points || std::ranges::adjacent_find(series.x, std::greater_equal()) == series.x.end();
}

}  // namespace

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
    std::vector<Series>& series = both.panels_[i].series;
    series.insert(series.end(), under.begin(), under.end());
  }
  return both;
}

void Figure::write(const fs::path& folder) const { writeFigures({*this}, folder); }

void writeFigures(const std::vector<Figure>& figures, const fs::path& folder) {
  if (figures.empty()) return;
  std::set<std::string> ids;
  for (const Figure& figure : figures) {
    if (ids.insert(figure.id()).second) continue;
    throw std::invalid_argument(fmt::format("writeFigures: two figures have the id '{}'", figure.id()));
  }

  const TemporaryFolder work(folder);
  std::vector<std::string> scripts;
  for (const Figure& figure : figures) {
    const FigureText text = figureText(figure);
    writeFile(work.path() / (figure.id() + ".dat"), text.data);
    writeFile(work.path() / (figure.id() + ".gp"), text.script);
    scripts.push_back(figure.id() + ".gp");
  }
  runGnuplot(work.path(), scripts);
  for (const Figure& figure : figures) {
    if (isComplete(readFile(work.path() / (figure.id() + ".svg")))) continue;
    throw std::runtime_error(fmt::format("gnuplot drew no complete figure '{}'", figure.id()));
  }
  for (const std::string& id : ids) {
    for (const char* extension : {".dat", ".gp", ".svg"})
      publish(work.path() / (id + extension), folder / (id + extension));
  }
}

}  // namespace muelle
