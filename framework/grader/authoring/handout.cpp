#include "grader/authoring/handout.h"

#include "base/file.h"
#include "course/check/handed_out.h"
#include "grader/authoring/handed_out_files.h"

#include <fmt/format.h>
#include <algorithm>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace muelle::grader {

namespace fs = std::filesystem;

namespace {

constexpr const char* launcherName = "muelle";
constexpr const char* listName = "framework/course/handed_out.txt";
constexpr const char* presetsName = "CMakePresets.json";
constexpr const char* studentsReadme = "framework/grader/authoring/handout/README.md";

/// Those that the launcher needs; the others are about tests that are not handed out.
std::string studentsPresets(const std::string& text) {
  auto all = nlohmann::ordered_json::parse(text);
  all.erase("testPresets");
  for (const char* kind : {"configurePresets", "buildPresets"}) {
    auto kept = nlohmann::ordered_json::array();
    for (const auto& preset : all[kind]) {
      if (preset["name"] == "default") kept.push_back(preset);
    }
    all[kind] = kept;
  }
  return all.dump(2) + "\n";
}

/// Texts that lie on this machine alone.
std::vector<std::string> pathsOfThisMachine(const fs::path& checkout) {
  std::vector<std::string> paths = {checkout.string()};
  const char* home = std::getenv("HOME");
  if (home != nullptr && std::string_view(home).size() > 1) paths.push_back(std::string(home) + "/");
  return paths;
}

/// The list that tells a student which files have changed.
std::string listOfHandedOut(const Tree& tree, const fs::path& parent) {
  const TemporaryFolder scratch(parent);
  for (const auto& [file, text] : tree) {
    fs::create_directories((scratch.path() / file).parent_path());
    writeFile(scratch.path() / file, text);
  }
  return handedOutList(scratch.path());
}

void writeTree(const Tree& tree, const fs::path& folder) {
  for (const auto& [file, text] : tree) {
    fs::create_directories((folder / file).parent_path());
    writeFile(folder / file, text);
    const bool runs = file == launcherName;
    fs::permissions(folder / file,
                    fs::perms::owner_read | fs::perms::owner_write | fs::perms::group_read | fs::perms::others_read);
    if (runs) {
      fs::permissions(folder / file, fs::perms::owner_exec | fs::perms::group_exec | fs::perms::others_exec,
                      fs::perm_options::add);
    }
  }
}

bool isEmpty(const fs::path& folder) {
  return !fs::exists(folder) || (fs::is_directory(folder) && fs::is_empty(folder));
}

/// Of a student, not of an instructor.
bool isHandout(const fs::path& folder) {
  return fs::exists(folder / launcherName) && fs::exists(folder / listName) && !isAuthors(folder);
}

void refuseBadFolder(const fs::path& checkout, const fs::path& folder, Replace replace) {
  const fs::path inside = folder.lexically_relative(checkout);
  const bool isInside = !inside.empty() && *inside.begin() != "..";
  if (isInside && *inside.begin() != "out") {
    throw std::runtime_error(
        fmt::format("{} lies in the checkout: give a folder elsewhere, or below out/", folder.string()));
  }
  if (isEmpty(folder)) return;
  if (!fs::is_directory(folder)) throw std::runtime_error(fmt::format("{} is no folder", folder.string()));
  if (!isHandout(folder)) {
    throw std::runtime_error(fmt::format("{} is not empty and no student's tree: give a new folder", folder.string()));
  }
  if (replace == Replace::No) {
    throw std::runtime_error(
        fmt::format("{} holds a student's tree: --force replaces it, all but its .git", folder.string()));
  }
}

/// Puts `fresh` in the place of `folder`, whose history it takes over; what was there goes to `old`.
void exchange(const fs::path& fresh, const fs::path& folder, const fs::path& old) {
  fs::rename(folder, old);
  try {
    if (fs::exists(old / ".git")) fs::rename(old / ".git", fresh / ".git");
    fs::rename(fresh, folder);
  } catch (...) {
    if (fs::exists(fresh / ".git")) fs::rename(fresh / ".git", old / ".git");
    fs::rename(old, folder);
    throw;
  }
}

}  // namespace

Handout readHandout(const fs::path& checkout) {
  HandedOutFiles found = handedOutFiles(checkout);
  Handout handout;
  handout.notes = std::move(found.notes);
  for (const std::string& file : found.files) handout.tree[file] = readFile(checkout / file);
  handout.tree["README.md"] = readFile(checkout / studentsReadme);
  handout.tree[presetsName] = studentsPresets(readFile(checkout / presetsName));
  handout.tree[listName] = listOfHandedOut(handout.tree, fs::temp_directory_path());
  handout.leaks = findLeaks(handout.tree, readWithheld(checkout), pathsOfThisMachine(checkout));
  return handout;
}

void writeHandout(const Handout& handout, const fs::path& checkout, const fs::path& given, Replace replace) {
  fs::path folder = fs::absolute(given).lexically_normal();
  if (!folder.has_filename()) folder = folder.parent_path();  // "DIR/"
  refuseBadFolder(checkout, folder, replace);
  const TemporaryFolder scratch(folder.parent_path());  // beside it: a rename stays on one disk
  const fs::path fresh = scratch.path() / "new";
  writeTree(handout.tree, fresh);
  if (isEmpty(folder)) {
    fs::remove(folder);
    fs::rename(fresh, folder);
  } else {
    exchange(fresh, folder, scratch.path() / "old");
  }
}

}  // namespace muelle::grader
