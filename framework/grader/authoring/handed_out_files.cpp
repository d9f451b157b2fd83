#include "grader/authoring/handed_out_files.h"

#include "base/process/child.h"

#include <fmt/format.h>
#include <algorithm>
#include <optional>
#include <set>
#include <sstream>

namespace muelle::grader {

namespace fs = std::filesystem;

namespace {

/// What stands at the top of a student's tree as it stands here.
constexpr const char* topFiles[] = {".gitignore", "CMakeLists.txt", "LICENSE", "muelle"};

bool isHidden(const fs::path& path) { return path.filename().string().starts_with('.'); }

class Collection {
 public:
  explicit Collection(fs::path checkout) : checkout_(std::move(checkout)) {}

  void add(const fs::path& file) { files_.push_back(file.lexically_relative(checkout_).generic_string()); }

  void addFolder(const fs::path& folder) {
    for (auto entry = fs::recursive_directory_iterator(folder); entry != fs::end(entry); ++entry) {
      const bool isLeftOut = isHidden(entry->path()) || entry->is_symlink();
      if (isLeftOut && entry->is_directory()) entry.disable_recursion_pending();
      if (!isLeftOut && entry->is_regular_file()) add(entry->path());
    }
  }

  void addFilesOf(const fs::path& folder) {
    for (const auto& entry : fs::directory_iterator(folder)) {
      if (entry.is_regular_file() && !entry.is_symlink() && !isHidden(entry.path())) add(entry.path());
    }
  }

  std::vector<std::string> sorted() {
    std::ranges::sort(files_);
    return std::move(files_);
  }

 private:
  fs::path checkout_;
  std::vector<std::string> files_;
};

/// What a git command lists of the checkout; nullopt where there is no git or no history.
std::optional<std::set<std::string>> gitList(const fs::path& checkout, std::vector<std::string> words) {
  if (!fs::exists(checkout / ".git")) return std::nullopt;
  ChildSpec git;
  git.command = {"git", "-C", checkout.string(), "-c", "core.quotePath=false"};
  git.command.insert(git.command.end(), words.begin(), words.end());
  git.inheritsEnvironment = true;
  constexpr std::size_t most = 16 << 20;  // [bytes] of names
  std::set<std::string> names;
  try {
    const CommandResult listed = runCommand(git, {std::chrono::minutes(1), most});
    if (!listed.status.success() || listed.outCut) return std::nullopt;
    std::istringstream lines(listed.out);
    for (std::string line; std::getline(lines, line);) names.insert(line);
  } catch (const std::exception&) {
    return std::nullopt;  // git is not installed
  }
  return names;
}

/// Without a manifest a folder is no exercise.
void addExercises(const fs::path& exercises, Collection& collection, std::vector<std::string>& notes) {
  for (const auto& entry : fs::directory_iterator(exercises)) {
    if (!entry.is_directory() || isHidden(entry.path())) continue;
    if (fs::exists(entry.path() / "exercise.toml")) {
      collection.addFolder(entry.path());
    } else {
      notes.push_back(fmt::format("left out: exercises/{} has no exercise.toml", entry.path().filename().string()));
    }
  }
}

/// An exercise of which git knows nothing is one line.
void noteLeftOut(const std::string& file, const std::set<std::string>& known, std::vector<std::string>& notes) {
  const std::string folder = file.starts_with("exercises/") ? file.substr(0, file.find('/', 10) + 1) : "";
  const auto next = known.lower_bound(folder);
  const bool isWhole = !folder.empty() && (next == known.end() || !next->starts_with(folder));
  std::string note =
      fmt::format("left out: {} (git does not know it: git add {})", isWhole ? folder : file, isWhole ? folder : file);
  if (notes.empty() || notes.back() != note) notes.push_back(std::move(note));
}

}  // namespace

HandedOutFiles handedOutFiles(const fs::path& checkout) {
  HandedOutFiles result;
  Collection collection(checkout);
  for (const char* file : topFiles) {
    if (fs::exists(checkout / file)) collection.add(checkout / file);
  }
  std::istringstream rooms(MUELLE_HANDED_OUT_ROOMS);
  for (std::string room; rooms >> room;) collection.addFolder(checkout / "framework" / room);
  collection.addFolder(checkout / "framework/cmake");
  collection.addFilesOf(checkout / "framework/app");
  addExercises(checkout / "exercises", collection, result.notes);
  const auto known = gitList(checkout, {"ls-files"});
  const auto changed = gitList(checkout, {"diff", "--name-only", "HEAD"});
  for (std::string& file : collection.sorted()) {
    if (known && !known->contains(file)) {
      noteLeftOut(file, *known, result.notes);
      continue;
    }
    if (changed && changed->contains(file)) {
      result.notes.push_back(fmt::format("{} goes out with changes that are not committed", file));
    }
    result.files.push_back(std::move(file));
  }
  return result;
}

}  // namespace muelle::grader
