#include "lab/hard_cases/cell_text.h"
#include "lab/hard_cases/report.h"

#include <fmt/format.h>
#include <cmath>

namespace muelle::hard_cases {

Figure matrixFigure(const Matrix& matrix) {
  Figure figure("hard_cases", "Methods fail where it was predicted (numbers: power of ten of the error)", "");
  figure.slide();
  struct Category {
    const char* name;
    int colour;
    std::vector<double> x = {}, y = {};
  };
  Category categories[] = {
      {"passed, 100 times below the bar", 5}, {"passed", 2}, {"failed as predicted", 4}, {"failed unexpectedly", 1}};
  const auto rows = matrix.variants.size();
  std::vector<std::string> methodNames, variantNames;
  for (const std::string& method : matrix.methods) methodNames.push_back(shortName(method));
  for (std::size_t v = rows; v-- > 0;) variantNames.push_back(matrix.variants[v].label());
  auto panel = figure.panel("");
  for (std::size_t m = 0; m < matrix.methods.size(); ++m) {
    for (std::size_t v = 0; v < rows; ++v) {
      const Cell& cell = matrix.at(m, v);
      const double x = static_cast<double>(m), y = static_cast<double>(rows - 1 - v);
      if (cell.outcome == Outcome::NotApplicable) {
        panel.note(x, y, "n/a", true);
        continue;
      }
      const bool ample = cell.error < 0.01 * matrix.variants[v].bar;
      Category& category = cell.outcome == Outcome::Passed              ? categories[ample ? 0 : 1]
                           : cell.outcome == Outcome::FailedAsPredicted ? categories[2]
                                                                        : categories[3];
      category.x.push_back(x);
      category.y.push_back(y);
      const std::string power = !std::isfinite(cell.error) ? "stop"
                                : cell.error == 0.0        ? "exact"
                                                           : fmt::format("{:.0f}", std::floor(std::log10(cell.error)));
      panel.note(x, y, power, true);
    }
  }
  for (Category& category : categories) {
    if (category.x.empty()) continue;
    panel.cells(category.name, category.x, category.y).colour(category.colour);
  }
  panel.xNames(methodNames).yNames(variantNames);
  return figure;
}

}  // namespace muelle::hard_cases
