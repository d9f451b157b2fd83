#include "grader/intake/looks_like_a_class.h"

#include "base/text/printable.h"
#include "grader/intake/class_folder.h"
#include "grader/intake/file_names.h"

#include <fmt/format.h>
#include <algorithm>
#include <cctype>
#include <map>
#include <set>
#include <system_error>

namespace muelle::grader {

namespace {

namespace fs = std::filesystem;

constexpr int lookedIntoDepth = 4;
constexpr const char* unknownTopic = "";  ///< of what lies in an archive
constexpr int lookedAtEntries = 1000;     ///< of one child

bool isTopicFolder(const std::string& name, const Manifest& manifest) {
  return name == manifest.topic || isNearFolderName(name, manifest.topic);
}

/// The topics that a file or folder of that name is for.
void addTopicsOf(const std::string& name, bool isFolder, const std::vector<Manifest>& course,
                 std::set<std::string>& topics) {
  for (const Manifest& manifest : course) {
    const bool isWanted =
        isFolder ? isTopicFolder(name, manifest)
                 : std::any_of(manifest.files.begin(), manifest.files.end(),
                               [&](const std::string& wanted) { return name == wanted || isNearName(name, wanted); });
    if (isWanted) topics.insert(manifest.topic);
  }
}

std::set<std::string> topicsInside(const fs::path& folder, const std::vector<Manifest>& course) {
  std::set<std::string> topics;
  std::error_code error;
  fs::recursive_directory_iterator entry(folder, fs::directory_options::skip_permission_denied, error);
  for (int seen = 0; !error && entry != fs::recursive_directory_iterator() && seen < lookedAtEntries; ++seen) {
    const std::string name = entry->path().filename().string();
    std::error_code unknown;
    const bool isFolder = entry->is_directory(unknown) && !entry->is_symlink(unknown);
    if (isFolder && (name.starts_with('.') || entry.depth() >= lookedIntoDepth)) entry.disable_recursion_pending();
    addTopicsOf(name, isFolder, course, topics);
    if (!isFolder && isArchiveName(name)) topics.insert(unknownTopic);
    entry.increment(error);
  }
  return topics;
}

bool isServersName(const std::string& name) {
  const bool isGradescopes =
      name.starts_with("submission_") && name.find_first_not_of("0123456789", 11) == std::string::npos;
  return isGradescopes || name.find("_assignsubmission_") != std::string::npos;
}

bool isCourseFolder(const std::string& name) {
  const std::string lower = lowerCase(name);
  return lower == "exercises" || lower == "solutions";
}

/// What tells a class from a hand-in, counted over the children.
struct Signs {
  bool isAHandIn = false;
  std::set<std::string> archives;       ///< by student, where the server's name tells one
  std::set<std::string> named;          ///< students of whom the server's names tell
  std::map<std::string, int> numbered;  ///< topic -> children named after it with a number behind: "contact-3"
  std::map<std::string, int> topics;    ///< topic -> folders that hold something for it

  int copies() const {
    int most = 0;
    for (const auto& [topic, count] : numbered) most = std::max(most, count);
    return most;
  }
};

/// "contact-3": an exercise's folder that was made twice, or the third student's of a class.
bool isNumbered(const std::string& name) {
  return std::isdigit(static_cast<unsigned char>(name.back())) != 0 && name.find('(') == std::string::npos;
}

/// Whether a child's name is that of a part of a hand-in.
void lookAtName(const std::string& name, bool isFolder, const std::vector<Manifest>& course, Signs& signs) {
  std::set<std::string> own;
  addTopicsOf(name, isFolder, course, own);
  const std::string bare = isArchiveName(name) ? withoutArchiveSuffix(name) : name;
  if (isArchiveName(name)) addTopicsOf(bare, true, course, own);
  const bool isExact = std::any_of(own.begin(), own.end(), [&](const std::string& topic) { return topic == bare; });
  if (isExact || !isNumbered(bare)) {
    signs.isAHandIn |= !own.empty();
  } else {
    for (const std::string& topic : own) ++signs.numbered[topic];
  }
}

/// \param topics of what lies in the child, when it is a folder
template <class Topics>
void look(const std::string& name, bool isFolder, const Topics& topicsOf, const std::vector<Manifest>& course,
          Signs& signs) {
  if (name.starts_with('.') || name == "__MACOSX") return;
  const bool isNamed = isServersName(name);
  if (!isNamed) lookAtName(name, isFolder, course, signs);
  if (!isFolder && isArchiveName(name)) {
    signs.archives.insert(studentOf(name));
  } else if (isNamed) {
    signs.named.insert(studentOf(name));
  }
  if (!isFolder) return;
  const std::set<std::string> topics = topicsOf();
  signs.isAHandIn |= isCourseFolder(name) && !topics.empty();
  for (const std::string& topic : topics) ++signs.topics[topic];
}

/// "28 archives", "2 hand-ins"; nullopt when it is no class.
std::optional<std::string> whatItHolds(const Signs& signs) {
  if (signs.isAHandIn || signs.copies() == 1) return std::nullopt;
  auto folders = static_cast<int>(signs.named.size());
  for (const auto& [topic, count] : signs.topics) folders = std::max(folders, count);
  const auto archives = static_cast<int>(signs.archives.size());
  if (archives < 2 && folders < 2) return std::nullopt;
  return archives >= folders ? fmt::format("{} archives", archives) : fmt::format("{} hand-ins", folders);
}

/// An archive mostly holds one folder, with all in it. \return how many components of each path to pass over
std::size_t depthOfChildren(const std::vector<RelativePath>& files, const std::vector<Manifest>& course) {
  std::set<std::string> tops;
  for (const RelativePath& file : files) tops.insert(file.size() > 1 ? file.front() : "");
  tops.erase("__MACOSX");
  if (tops.size() != 1 || tops.contains("")) return 0;
  std::set<std::string> own;
  addTopicsOf(*tops.begin(), true, course, own);
  return own.empty() && !isServersName(*tops.begin()) && !isCourseFolder(*tops.begin()) ? 1 : 0;
}

/// The topics of one file's path below its child.
void addTopicsBelow(const RelativePath& file, std::size_t first, const std::vector<Manifest>& course,
                    std::set<std::string>& topics) {
  for (std::size_t i = first; i < file.size(); ++i) addTopicsOf(file[i], i + 1 < file.size(), course, topics);
  if (isArchiveName(file.back())) topics.insert(unknownTopic);
}

}  // namespace

std::optional<std::string> looksLikeAClass(const std::filesystem::path& path, const std::vector<Manifest>& course) {
  Signs signs;
  std::error_code error;
  if (!fs::is_directory(path, error)) return std::nullopt;
  for (fs::directory_iterator child(path, error), end; !error && child != end; child.increment(error)) {
    std::error_code unknown;
    look(
        child->path().filename().string(), child->is_directory(unknown),
        [&] { return topicsInside(child->path(), course); }, course, signs);
  }
  const std::optional<std::string> what = error ? std::nullopt : whatItHolds(signs);
  if (!what) return std::nullopt;
  return fmt::format("holds {}; to grade each as a submission: ./muelle grade --class {}", *what,
                     cut(printableLine(path.string()), 200));
}

std::optional<std::string> archiveOfAClass(const std::vector<RelativePath>& files,
                                           const std::vector<Manifest>& course) {
  const std::size_t depth = depthOfChildren(files, course);
  std::map<std::string, std::set<std::string>> folders;
  std::set<std::string> bare;
  for (const RelativePath& file : files) {
    if (file.size() <= depth || file.front() == "__MACOSX") continue;
    if (file.size() == depth + 1) {
      bare.insert(file.back());
    } else {
      addTopicsBelow(file, depth + 1, course, folders[file[depth]]);
    }
  }
  Signs signs;
  for (const std::string& name : bare)
    look(
        name, false, [] { return std::set<std::string>(); }, course, signs);
  for (const auto& [name, topics] : folders) {
    look(
        name, true, [&topics = topics] { return topics; }, course, signs);
  }
  const std::optional<std::string> what = whatItHolds(signs);
  if (!what) return std::nullopt;
  return fmt::format("the archive holds {}: if that is a class, unpack it and type ./muelle grade --class FOLDER",
                     *what);
}

}  // namespace muelle::grader
