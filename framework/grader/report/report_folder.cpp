#include "grader/report/report_folder.h"

#include "base/file.h"
#include "base/text/printable.h"
#include "grader/run/digest.h"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <stdexcept>
#include <system_error>

namespace muelle::grader {

namespace fs = std::filesystem;

namespace {

constexpr const char* ownerFile = ".submission";
constexpr std::size_t longestName = 100;

/// The folder by its own name: "reports" of "reports/".
fs::path withoutEndingSlash(const fs::path& folder) { return folder.has_filename() ? folder : folder.parent_path(); }

/// True when `path` lies in `folder`; both without links.
bool isInside(const fs::path& path, const fs::path& folder) {
  return std::mismatch(folder.begin(), folder.end(), path.begin(), path.end()).first == folder.end();
}

/// True for a link out of the folder it stands in.
bool leadsOut(const fs::path& folder) {
  if (!fs::is_symlink(folder)) return false;
  const fs::path parent = folder.has_parent_path() ? folder.parent_path() : fs::path(".");
  return !isInside(fs::weakly_canonical(folder), fs::canonical(parent));
}

/// Whose reports the folder holds, by its mark; "" when nobody's.
std::string ownerOf(const fs::path& folder) {
  return leadsOut(withoutEndingSlash(folder)) ? "" : tryReadFile(folder / ownerFile).value_or("");
}

/// A submission as a mark names it.
std::string ownerName(const fs::path& submission) {
  return withoutEndingSlash(fs::absolute(submission).lexically_normal()).string();
}

/// Makes the folder ours, or finds that it is. The file that says whose it is appears with its content.
bool take(const fs::path& folder, const std::string& owner) {
  refuseLinkOut(folder);
  fs::create_directories(folder);
  const fs::path mark = folder / ownerFile;
  std::error_code missing;
  if (fs::exists(mark, missing)) return readFile(mark) == owner;
  const fs::path fresh = folder / fmt::format("{}.{}", ownerFile, digest({owner}).substr(0, 16));
  writeFile(fresh, owner);
  std::error_code taken;
  fs::create_hard_link(fresh, mark, taken);
  if (taken && taken != std::errc::file_exists) fs::rename(fresh, mark);  // a disk that knows no second name of a file
  std::error_code gone;
  fs::remove(fresh, gone);
  return !taken || readFile(mark) == owner;
}

/// Both names that a submission's folder may have below `parent`; the second is no other submission's.
std::array<fs::path, 2> candidates(const fs::path& parent, const std::string& owner) {
  const std::string name = fileNameFor(fs::path(owner).filename().string());
  return {parent / name, parent / fmt::format("{}-{}", name, digest({owner}).substr(0, 8))};
}

}  // namespace

std::string fileNameFor(const std::string& name) {
  std::string safe;
  for (const char c : printableLine(name)) safe += c == '/' || c == '\\' ? '_' : c;
  safe.erase(0, safe.find_first_not_of(". "));
  safe = cut(safe, longestName);
  return safe.empty() ? "submission" : safe;
}

fs::path reportFolder(const fs::path& parent, const fs::path& submission) {
  const std::string owner = ownerName(submission);
  const auto [named, other] = candidates(parent, owner);
  try {
    if (take(named, owner)) return named;
    take(other, owner);
    return other;
  } catch (const fs::filesystem_error& error) {
    throw std::system_error(error.code(), fmt::format("cannot make a folder for the reports in {}, give another with "
                                                      "--out",
                                                      parent.string()));
  }
}

std::optional<fs::path> findReportFolder(const fs::path& parent, const fs::path& submission) {
  const std::string owner = ownerName(submission);
  for (const fs::path& folder : candidates(parent, owner)) {
    if (isOwn(folder, submission)) return folder;
  }
  return std::nullopt;
}

bool isOwn(const fs::path& folder, const fs::path& submission) { return ownerOf(folder) == ownerName(submission); }

void requireOwn(const fs::path& folder, const fs::path& submission) {
  const std::string owner = ownerOf(folder);
  if (owner.empty() || owner == ownerName(submission)) return;
  throw std::invalid_argument(fmt::format("{} holds the reports of {}: for those of {}, give another folder with --out",
                                          folder.string(), owner, submission.string()));
}

void requireOutside(const fs::path& folder, const fs::path& submission) {
  if (!fs::is_directory(submission)) return;
  if (!isInside(withoutEndingSlash(fs::weakly_canonical(fs::absolute(folder))), fs::canonical(submission))) return;
  throw std::invalid_argument(
      fmt::format("the reports would be written into {}, where the next run reads them as handed in: give a folder "
                  "outside it with --out",
                  submission.string()));
}

void claim(const fs::path& folder, const fs::path& submission) {
  if (!take(folder, ownerName(submission))) requireOwn(folder, submission);
}

void refuseLinkOut(const fs::path& folder) {
  if (!leadsOut(withoutEndingSlash(folder))) return;
  throw std::runtime_error(
      fmt::format("cannot write the reports into {}: it is a link that leads out of its folder; remove it, or name the "
                  "folder that it leads to",
                  folder.string()));
}

}  // namespace muelle::grader
