#include "course/check/drawn_figures.h"

#include "base/file.h"

#include <sstream>
#include <string>

namespace muelle {

namespace fs = std::filesystem;

namespace {

fs::path listIn(const fs::path& folder) { return folder / "drawn.txt"; }

}  // namespace

void removeDrawnFigures(const fs::path& folder) {
  std::istringstream names(tryReadFile(listIn(folder)).value_or(""));
  for (std::string name; std::getline(names, name);) {
    // The list may have been edited: nothing outside of the folder is touched.
    const fs::path drawing = folder / fs::path(name).filename();
    for (const char* extension : {".svg", ".dat", ".gp"}) {
      std::error_code absent;
      fs::remove(fs::path(drawing).replace_extension(extension), absent);
    }
  }
}

void noteDrawnFigures(const fs::path& folder, const std::vector<fs::path>& figures) {
  std::string names;
  for (const fs::path& figure : figures) names += figure.filename().string() + "\n";
  writeFile(listIn(folder), names);
}

}  // namespace muelle
