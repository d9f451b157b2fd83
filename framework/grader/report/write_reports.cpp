#include "grader/report/report.h"

#include "base/file.h"
#include "grader/report/report_folder.h"

#include <array>
#include <system_error>

namespace muelle::grader {

namespace fs = std::filesystem;

namespace {

constexpr std::array names{"report.html", "results.xml", "results.json"};

}  // namespace

void writeReports(const GradedSubmission& graded, const fs::path& folder) {
  refuseLinkOut(folder);
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw std::system_error(error, "cannot make the folder " + folder.string());
  // The scores last: where the disk fills up, they do not stand without the page that explains them.
  writeFile(folder / names[0], htmlPage(graded));
  writeFile(folder / names[1], junitXml(graded));
  writeFile(folder / names[2], resultsJson(graded), Durable::Yes);
}

void removeReports(const fs::path& folder) {
  for (const char* name : names) {
    std::error_code error;
    fs::remove(folder / name, error);
    if (error) throw std::system_error(error, "cannot remove the old report " + (folder / name).string());
  }
}

}  // namespace muelle::grader
