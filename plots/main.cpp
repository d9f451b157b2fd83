/// \file
/// `muelle figures`: draws the lecture's figures.

#include "base/command_line.h"
#include "base/errors.h"
#include "base/progress_bar.h"
#include "base/text/count.h"
#include "base/text/nearest.h"
#include "base/text/printable.h"
#include "figure_list.h"
#include "figures/write.h"

#include <fmt/format.h>
#include <filesystem>
#include <stdexcept>

namespace {

using muelle::Figure;
using muelle::Format;
using muelle::plots::LectureFigure;
using muelle::plots::lectureFigures;

struct Command {
  std::vector<std::string> names;
  std::string out = "out/figures";
  std::vector<std::string> formats = {"svg", "pdf", "png"};
  bool list = false;
};

const LectureFigure& find(const std::string& name) {
  std::vector<std::string> known;
  for (const LectureFigure& figure : lectureFigures()) {
    if (figure.name == name) return figure;
    known.push_back(figure.name);
  }
  const std::string guess = muelle::didYouMean(name, known);
  throw std::invalid_argument(fmt::format("no figure '{}'{}", muelle::printableLine(name),
                                          guess.empty() ? "; ./muelle figures --list names them" : guess));
}

std::vector<LectureFigure> chosen(const Command& command) {
  if (command.names.empty()) return lectureFigures();
  std::vector<LectureFigure> figures;
  for (const std::string& name : command.names) figures.push_back(find(name));
  return figures;
}

std::vector<Format> formatsOf(const Command& command) {
  std::vector<Format> formats;
  for (const std::string& name : command.formats) {
    formats.push_back(name == "svg" ? Format::Svg : name == "pdf" ? Format::Pdf : Format::Png);
  }
  return formats;
}

int list() {
  for (const LectureFigure& figure : lectureFigures()) fmt::print("{}\n", figure.name);
  return 0;
}

int draw(const Command& command) {
  if (command.list) return list();
  const std::vector<LectureFigure> figures = chosen(command);
  const std::vector<Format> formats = formatsOf(command);
  muelle::ProgressBar progress("figures");
  double done = 0.0;
  for (const LectureFigure& figure : figures) {
    // One at a time, so that what is drawn stays when the run is broken off.
    muelle::writeFigures({figure.draw()}, command.out, formats);
    progress.update(++done / static_cast<double>(figures.size()));
  }
  fmt::print("{} in {}\n", muelle::counted(std::ssize(figures), "figure"),
             std::filesystem::path(command.out).lexically_normal().string());
  return 0;
}

int parseAndDraw(int argc, char** argv) {
  Command command;
  muelle::CommandLine program("./muelle figures", "Draws the figures of the lecture.");
  program.option("NAME", command.names, "The figures to draw [all]");
  program.option("--out", command.out, "Folder for the files").showDefault();
  program.option("--format", command.formats, "svg, pdf, png, separated by commas [all three]")
      .separator(',')
      .oneOf({"svg", "pdf", "png"});
  program.flag("--list", command.list, "Name the figures, draw none");
  program.footer(
      "Examples: ./muelle figures\n"
      "          ./muelle figures buckling bounce --format png --out slides");
  program.action([&command] { return draw(command); });
  return program.run(argc, argv);
}

}  // namespace

int main(int argc, char** argv) {
  return muelle::withErrorsOnOneLine([=] { return parseAndDraw(argc, argv); });
}
