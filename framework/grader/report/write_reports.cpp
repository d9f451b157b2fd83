#include "grader/report/report.h"

#include "base/file.h"

#include <fmt/format.h>
#include <algorithm>
#include <stdexcept>

namespace muelle::grader {

namespace {

namespace fs = std::filesystem;

/// The folder by its own name: "reports" of "reports/".
fs::path withoutEndingSlash(const fs::path& folder) { return folder.has_filename() ? folder : folder.parent_path(); }

/// True when `path` lies in `folder`; both without links.
bool isInside(const fs::path& path, const fs::path& folder) {
  return std::mismatch(folder.begin(), folder.end(), path.begin(), path.end()).first == folder.end();
}

void refuseLinkOut(const fs::path& folder) {
  if (!fs::is_symlink(folder)) return;
  const fs::path parent = folder.has_parent_path() ? folder.parent_path() : fs::path(".");
  if (isInside(fs::weakly_canonical(folder), fs::canonical(parent))) return;
  throw std::runtime_error(
      fmt::format("cannot write the reports into {}: it is a link that leads out of its folder; remove it, or name the "
                  "folder that it leads to",
                  folder.string()));
}

}  // namespace

void writeReports(const GradedSubmission& graded, const fs::path& folder) {
  refuseLinkOut(withoutEndingSlash(folder));
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw std::runtime_error(fmt::format("cannot make the folder {}: {}", folder.string(), error.message()));
  // The scores last: where the disk fills up, they do not stand without the page that explains them.
  writeFile(folder / "report.html", htmlPage(graded));
  writeFile(folder / "results.xml", junitXml(graded));
  writeFile(folder / "results.json", resultsJson(graded));
}

}  // namespace muelle::grader
