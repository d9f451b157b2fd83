#include "grader/report/report.h"

#include "base/file.h"

#include <fmt/format.h>
#include <stdexcept>

namespace muelle::grader {

void writeReports(const GradedSubmission& graded, const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw std::runtime_error(fmt::format("cannot make the folder {}: {}", folder.string(), error.message()));
  writeFile(folder / "results.json", resultsJson(graded));
  writeFile(folder / "results.xml", junitXml(graded));
  writeFile(folder / "report.html", htmlPage(graded));
}

}  // namespace muelle::grader
