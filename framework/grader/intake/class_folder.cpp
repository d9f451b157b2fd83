#include "grader/intake/class_folder.h"

#include "base/text/printable.h"
#include "grader/intake/file_names.h"
#include "grader/intake/package.h"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <fstream>
#include <map>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <utility>

namespace muelle::grader {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t shownBytes = 200;
constexpr std::string_view childMark = "_assignsubmission_";
constexpr std::array<std::string_view, 33> papers{
    ".csv", ".xls",  ".xlsx", ".ods",  ".pdf", ".txt", ".md",  ".html", ".json", ".yml",    ".yaml",
    ".xml", ".log",  ".docx", ".toml", ".db",  ".ini", ".png", ".jpg",  ".jpeg", ".gif",    ".svg",
    ".bmp", ".heic", ".mp4",  ".mov",  ".o",   ".out", ".exe", ".url",  ".lnk",  ".webloc", ".desktop"};
constexpr std::array<std::string_view, 5> systems{".DS_Store", ".localized", ".directory", ".git", "__MACOSX"};

/// "Name Surname_12345_assignsubmission_KIND..." in its parts.
struct MoodleName {
  std::string name;
  std::string id;
  std::string kind;  ///< begins with "file" or "onlinetext"
};

std::optional<MoodleName> moodleName(const std::string& raw) {
  const std::size_t mark = raw.find(childMark);
  if (mark == std::string::npos || mark == 0) return std::nullopt;
  const std::size_t line = raw.rfind('_', mark - 1);
  if (line == std::string::npos || line == 0 || line + 1 == mark) return std::nullopt;
  const std::string id = raw.substr(line + 1, mark - line - 1);
  if (id.find_first_not_of("0123456789") != std::string::npos) return std::nullopt;
  return MoodleName{raw.substr(0, line), id, raw.substr(mark + childMark.size())};
}

std::string shown(const std::string& raw) { return cut(printableLine(raw), shownBytes); }

bool isASystems(const std::string& name) {
  return name.starts_with("._") || std::find(systems.begin(), systems.end(), name) != systems.end();
}

/// True for texts, pictures and the like; a damaged archive under a strange name is none of these.
bool isAPaper(const fs::path& file, const std::string& name) {
  const std::string lower = lowerCase(name);
  if (std::any_of(papers.begin(), papers.end(), [&](auto suffix) { return lower.ends_with(suffix); })) return true;
  std::ifstream stream(file, std::ios::binary);
  if (!stream) return false;  // taking it says why it cannot be read
  std::string head(headBytes, '\0');
  stream.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(stream.gcount()));
  return head.find('\0') == std::string::npos && !isArchive(name, head) && !standIn(name, head);
}

/// Why a child is no submission; "" when it is one.
std::string whyNot(const fs::directory_entry& child, const std::string& name) {
  std::error_code unknown;
  const bool isPlaceholder = standIn(name, "").has_value();  // the Mac hides what stands for a student's archive
  if (name.starts_with('.') && !(isPlaceholder && child.is_regular_file(unknown))) return "hidden";
  const std::optional<MoodleName> moodle = moodleName(name);
  if (moodle && moodle->kind.starts_with("onlinetext")) return "a text typed online";
  if (child.is_directory(unknown)) return "";
  const bool isMeant = moodle || isSourceName(name) || isArchiveName(name);
  if (child.is_symlink(unknown) && !isMeant) return "a symbolic link";
  if (!child.is_regular_file(unknown) && !isMeant) return "no regular file";
  return !isMeant && isAPaper(child.path(), name) ? "no submission" : "";
}

/// Why a child that may be meant is not even opened; "" for all others.
std::string refusalOf(const fs::directory_entry& child, const std::string& name) {
  std::error_code unknown;
  if (!child.is_symlink(unknown)) return "";
  return shown(name) + " is a symbolic link: put the hand-in itself into the folder";
}

/// Puts together what Moodle gives side by side: "Ana_7_assignsubmission_file_a.cpp", "..._file_b.cpp". By path before.
void join(std::vector<ClassEntry>& entries) {
  std::map<std::pair<std::string, std::string>, std::size_t> known;
  std::vector<ClassEntry> joined;
  for (ClassEntry& entry : entries) {
    const std::optional<MoodleName> moodle = moodleName(entry.parts.front().filename().string());
    const auto found =
        moodle ? known.try_emplace({moodle->name, moodle->id}, joined.size()) : std::pair(known.end(), true);
    if (found.second) {
      joined.push_back(std::move(entry));
    } else {
      ClassEntry& one = joined[found.first->second];
      one.parts.push_back(std::move(entry.parts.front()));
      if (one.refusal.empty()) one.refusal = std::move(entry.refusal);
    }
  }
  entries = std::move(joined);
}

/// Makes the names that several entries share different: the child's own name in brackets, and a number where even
/// those are shown alike.
void tellApart(std::vector<ClassEntry>& entries) {
  std::map<std::string, int> count;
  for (const ClassEntry& entry : entries) ++count[entry.student];
  for (ClassEntry& entry : entries) {
    if (count[entry.student] > 1) entry.student += fmt::format(" [{}]", shown(entry.parts.front().filename().string()));
  }
  std::map<std::string, int> seen;
  for (ClassEntry& entry : entries) {
    while (const int before = seen[entry.student]++) entry.student += fmt::format(" #{}", before + 1);
  }
}

}  // namespace

std::string studentOf(const std::string& name) {
  if (const std::optional<MoodleName> moodle = moodleName(name))
    return fmt::format("{} ({})", shown(moodle->name), shown(moodle->id));
  if (isArchiveName(name)) return shown(withoutArchiveSuffix(name));
  return shown(isSourceName(name) ? withoutSourceSuffix(name) : name);
}

ClassFolder listClass(const std::filesystem::path& folder) {
  ClassFolder listing;
  std::error_code error;
  for (fs::directory_iterator child(folder, error), end; !error && child != end; child.increment(error)) {
    const std::string name = child->path().filename().string();
    if (isASystems(name)) continue;
    const std::string why = whyNot(*child, name);
    if (why.empty()) {
      listing.entries.push_back({{child->path()}, studentOf(name), refusalOf(*child, name)});
    } else {
      listing.notes.push_back(fmt::format("{} is not graded: {}", shown(name), why));
    }
  }
  if (error)
    throw std::runtime_error(fmt::format("cannot read the class folder {}: {}; give a folder of submissions",
                                         shown(folder.string()), error.message()));
  // By path first, so that the order is one whatever the file system's.
  std::sort(listing.entries.begin(), listing.entries.end(),
            [](const ClassEntry& a, const ClassEntry& b) { return a.parts < b.parts; });
  join(listing.entries);
  tellApart(listing.entries);
  std::sort(listing.entries.begin(), listing.entries.end(),
            [](const ClassEntry& a, const ClassEntry& b) { return a.student < b.student; });
  std::sort(listing.notes.begin(), listing.notes.end());
  return listing;
}

}  // namespace muelle::grader
