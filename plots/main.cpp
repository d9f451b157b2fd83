/// \file
/// `muelle figures`: draws the lecture's figures.

#include "base/errors.h"
#include "base/progress_bar.h"
#include "base/text/nearest.h"
#include "base/text/printable.h"
#include "figure_list.h"
#include "figures/write.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <filesystem>
#include <map>
#include <stdexcept>

namespace {

using muelle::Figure;
using muelle::Format;
using muelle::plots::LectureFigure;
using muelle::plots::lectureFigures;

struct Command {
  std::vector<std::string> names;
  std::string out = "out/figures";
  std::vector<Format> formats = {Format::Svg, Format::Pdf, Format::Png};
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

int list() {
  for (const LectureFigure& figure : lectureFigures()) fmt::print("{}\n", figure.name);
  return 0;
}

int draw(const Command& command) {
  if (command.list) return list();
  const std::vector<LectureFigure> figures = chosen(command);
  muelle::ProgressBar progress("figures");
  double done = 0.0;
  for (const LectureFigure& figure : figures) {
    // One at a time, so that what is drawn stays when the run is broken off.
    muelle::writeFigures({figure.draw()}, command.out, command.formats);
    progress.update(++done / static_cast<double>(figures.size()));
  }
  fmt::print("{} figure{} in {}\n", figures.size(), figures.size() == 1 ? "" : "s",
             std::filesystem::path(command.out).lexically_normal().string());
  return 0;
}

int parseAndDraw(int argc, char** argv) {
  Command command;
  CLI::App app("Draws the figures of the lecture.", "./muelle figures");
  app.add_option("NAME", command.names, "The figures to draw [all]");
  app.add_option("--out", command.out, "Folder for the files")->capture_default_str();
  app.add_option("--format", command.formats, "svg, pdf, png, separated by commas [all three]")
      ->delimiter(',')
      ->transform(CLI::CheckedTransformer(
          std::map<std::string, Format>{{"svg", Format::Svg}, {"pdf", Format::Pdf}, {"png", Format::Png}}));
  app.add_flag("--list", command.list, "Name the figures, draw none");
  app.footer(
      "Examples: ./muelle figures\n"
      "          ./muelle figures buckling bounce --format png --out slides");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    // Calls for help are "errors" too, with exit code 0.
    if (error.get_exit_code() == 0) return app.exit(error);
    throw std::invalid_argument(fmt::format("{} (see ./muelle figures --help)", error.what()));
  }
  return draw(command);
}

}  // namespace

int main(int argc, char** argv) {
  return muelle::withErrorsOnOneLine([=] { return parseAndDraw(argc, argv); });
}
