#include "lab/run/result_files.h"

#include "figures/write.h"
#include "lab/run/summary_line.h"

#include <fmt/format.h>

namespace muelle::lab {

namespace {

void nameFile(const char* kind, const std::filesystem::path& file) {
  fmt::print("{}", summaryLine(kind, file.string()));
}

}  // namespace

ResultFiles::ResultFiles(const std::string& folder, const std::string& scene)
    : folder_(folder.empty() ? std::filesystem::path("out") / scene : std::filesystem::path(folder)) {
  std::filesystem::create_directories(folder_);
}

void ResultFiles::draw(const std::vector<Figure>& figures) const {
  writeFigures(figures, folder_);
  for (const Figure& figure : figures) nameFile("figure", folder_ / (figure.id() + ".svg"));
}

void ResultFiles::nameTable(const std::filesystem::path& file) { nameFile("table", file); }

}  // namespace muelle::lab
