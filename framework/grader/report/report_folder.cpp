#include "grader/report/report_folder.h"

#include "base/file.h"
#include "base/text/printable.h"
#include "grader/run/digest.h"

#include <fmt/format.h>
#include <stdexcept>

namespace muelle::grader {

namespace fs = std::filesystem;

namespace {

constexpr const char* ownerFile = ".submission";
constexpr std::size_t longestName = 100;

/// Makes the folder ours, or finds that it is. The file that says whose it is appears with its content.
bool take(const fs::path& folder, const std::string& owner) {
  fs::create_directories(folder);
  const fs::path mark = folder / ownerFile;
  std::error_code missing;
  if (fs::exists(mark, missing)) return readFile(mark) == owner;
  const fs::path fresh = folder / fmt::format("{}.{}", ownerFile, digest({owner}).substr(0, 16));
  writeFile(fresh, owner);
  std::error_code taken;
  fs::create_hard_link(fresh, mark, taken);
  fs::remove(fresh);
  return !taken || readFile(mark) == owner;
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
  const fs::path whole = fs::absolute(submission).lexically_normal();
  const fs::path named = whole.filename().empty() ? whole.parent_path() : whole;  // "solutions/"
  const std::string owner = named.string();
  const std::string name = fileNameFor(named.filename().string());
  try {
    if (take(parent / name, owner)) return parent / name;
    const fs::path other = parent / fmt::format("{}-{}", name, digest({owner}).substr(0, 8));
    take(other, owner);
    return other;
  } catch (const fs::filesystem_error& error) {
    throw std::runtime_error(fmt::format("cannot make a folder for the reports in {}: {}; give another with --out",
                                         parent.string(), error.code().message()));
  }
}

}  // namespace muelle::grader
