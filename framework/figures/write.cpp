#include "figures/write.h"

#include "base/file.h"
#include "figures/gnuplot.h"
#include "figures/script.h"

#include <fmt/format.h>
#include <set>
#include <stdexcept>

namespace muelle {

namespace fs = std::filesystem;

namespace {

void publish(const fs::path& from, const fs::path& to) {
  std::error_code error;
  fs::rename(from, to, error);
  if (error) throw std::runtime_error(fmt::format("cannot write {}: {}", to.string(), error.message()));
}

/// A drawing that was broken off ends otherwise.
bool isComplete(const std::string& drawing, Format format) {
  const char* end = format == Format::Svg ? "</svg>" : format == Format::Pdf ? "%%EOF" : "IEND";
  return drawing.find(end) != std::string::npos;
}

std::string drawingName(const Figure& figure, Format format) { return figure.id() + '.' + extensionOf(format); }

/// The name of the script of a format: the SVG's is the one that stays.
std::string scriptName(const Figure& figure, Format format) {
  return (format == Format::Svg ? figure.id() : drawingName(figure, format)) + ".gp";
}

void requireDifferentIds(const std::vector<Figure>& figures) {
  std::set<std::string> ids;
  for (const Figure& figure : figures) {
    if (ids.insert(figure.id()).second) continue;
    throw std::invalid_argument(fmt::format("writeFigures: two figures have the id '{}'", figure.id()));
  }
}

}  // namespace

void writeFigure(const Figure& figure, const fs::path& folder) { writeFigures({figure}, folder); }

void writeFigures(const std::vector<Figure>& figures, const fs::path& folder, const std::vector<Format>& formats) {
  if (figures.empty()) return;
  requireDifferentIds(figures);
  const TemporaryFolder work(folder);
  std::vector<std::string> scripts;
  for (const Figure& figure : figures) {
    for (const Format format : formats) {
      const FigureText text = figureText(figure, format);
      writeFile(work.path() / (figure.id() + ".dat"), text.data);
      scripts.push_back(scriptName(figure, format));
      writeFile(work.path() / scripts.back(), text.script);
    }
  }
  runGnuplot(work.path(), scripts);
  for (const Figure& figure : figures) {
    for (const Format format : formats) {
      if (isComplete(readFile(work.path() / drawingName(figure, format)), format)) continue;
      throw std::runtime_error(fmt::format("gnuplot drew no complete figure '{}'", figure.id()));
    }
  }
  for (const Figure& figure : figures) {
    publish(work.path() / (figure.id() + ".dat"), folder / (figure.id() + ".dat"));
    for (const Format format : formats) {
      const std::string drawing = drawingName(figure, format);
      publish(work.path() / drawing, folder / drawing);
      if (format == Format::Svg) publish(work.path() / scriptName(figure, format), folder / scriptName(figure, format));
    }
  }
}

}  // namespace muelle
