#include "course/check/dependencies.h"

#include "base/text/printable.h"

#include <fmt/format.h>
#include <algorithm>
#include <array>

namespace muelle {

namespace fs = std::filesystem;

namespace {

/// GNU's assembler lists what it reads; a Mac has another, and clang none of its own.
bool assemblerLists() {
#ifdef __APPLE__
  return false;
#else
  return !compilesWithClang();
#endif
}

/// Folders of the C library and the kernel below /usr/include; those of TBB are what <execution> itself includes.
constexpr auto systemFolders =
    std::to_array<std::string_view>({"arpa", "asm", "asm-generic", "bits", "c++", "gnu", "linux", "net", "netinet",
                                     "oneapi", "protocols", "rpc", "scsi", "sys", "tbb"});

/// Of folders that only a compiler or a Mac's development kit has.
constexpr auto compilerFolders =
    std::to_array<std::string_view>({"/c++/", "/gcc/", "/lib/clang/", "/lib64/clang/", ".sdk/usr/include/"});

bool isBelow(const fs::path& file, const fs::path& folder) {
  const auto [last, unused] = std::mismatch(folder.begin(), folder.end(), file.begin(), file.end());
  return last == folder.end() || (std::next(last) == folder.end() && last->empty());
}

/// The file between compiler and assembler: "/tmp/ccEPWJCf.s".
bool isBetweenTools(const fs::path& file) {
  const std::string name = file.filename().string();
  return name.size() == 10 && name.starts_with("cc") && name.ends_with(".s");
}

/// "fmt/format.h" of "/usr/include/fmt/format.h"; elsewhere the whole path.
std::string shownName(const fs::path& file) {
  const std::string path = file.string();
  constexpr std::string_view system = "/usr/include/";
  return path.starts_with(system) ? path.substr(system.size()) : path;
}

bool isVisible(const std::string& name, const CompilePlace& place, const std::vector<StudentFile>& files) {
  // The assembler calls the source by its bare name.
  if (std::ranges::find(files, name, &StudentFile::name) != files.end()) return true;
  const fs::path file = (place.folder / name).lexically_normal();
  if (isStandardHeader(file) || isBetweenTools(file)) return true;
  return std::ranges::any_of(
      place.visible, [&](const fs::path& folder) { return isBelow(file, (place.folder / folder).lexically_normal()); });
}

}  // namespace

std::vector<std::string> dependencyLists(const std::string& object) {
  std::vector<std::string> lists{object + ".d"};
  if (assemblerLists()) lists.push_back(object + ".asm.d");
  return lists;
}

std::vector<std::string> dependencyFlags(const std::string& object) {
  const std::vector<std::string> lists = dependencyLists(object);
  std::vector<std::string> flags{"-MD", "-MF", lists.front()};
  if (assemblerLists()) flags.insert(flags.end(), {"-Xassembler", "--MD", "-Xassembler", lists.back()});
  return flags;
}

std::vector<std::string> readDependencies(std::string_view lists) {
  std::vector<std::string> files;
  std::string word;
  const auto end = [&] {
    if (!word.empty() && word.back() != ':') files.push_back(word);
    word.clear();
  };
  for (std::size_t i = 0; i < lists.size(); ++i) {
    const char c = lists[i];
    const char next = i + 1 < lists.size() ? lists[i + 1] : '\n';
    const bool isEscape = (c == '\\' && (next == ' ' || next == '#' || next == ':')) || (c == '$' && next == '$');
    if (isEscape) word += lists[++i];
    if (isEscape || (c == '\\' && next == '\n')) continue;
    if (c == ' ' || c == '\n' || c == '\t') {
      end();
    } else {
      word += c;
    }
  }
  end();
  return files;
}

bool isStandardHeader(const fs::path& file) {
  const std::string path = file.string();
  if (path.starts_with("/usr/lib/") || path.starts_with("/usr/lib64/")) return true;
  const auto holds = [&](std::string_view folder) { return path.find(folder) != std::string::npos; };
  if (std::ranges::any_of(compilerFolders, holds)) return true;
  // A compiler that brings its own C library keeps it in a folder of the same form.
  constexpr std::string_view include = "/usr/include/";
  const std::size_t at = path.find(include);
  if (at == std::string::npos) return false;
  std::string_view rest = std::string_view(path).substr(at + include.size());
  std::size_t slash = rest.find('/');
  // "x86_64-linux-gnu/bits/types.h"
  if (slash != std::string_view::npos && rest.substr(0, slash).find("-linux-") != std::string_view::npos) {
    rest.remove_prefix(slash + 1);
    slash = rest.find('/');
  }
  return slash == std::string_view::npos ||
         std::ranges::find(systemFolders, rest.substr(0, slash)) != systemFolders.end();
}

CompileVerdict judgeDependencies(std::string_view lists, const CompilePlace& place,
                                 const std::vector<StudentFile>& files) {
  CompileVerdict verdict;
  for (const std::string& name : readDependencies(lists)) {
    if (isVisible(name, place, files)) continue;
    const std::string student = files.empty() ? "the file" : files.front().name;
    verdict.outcome = Outcome::Compile;
    verdict.message = fmt::format("it does not compile: {} reads {}, which is not there when it is graded", student,
                                  printableLine(shownName((place.folder / name).lexically_normal())));
    verdict.diagnostics = fmt::format(
        "{}\n      = only the contract, the harness, Eigen and the standard library are: write what you need of it "
        "into {}\n",
        verdict.message, student);
    return verdict;
  }
  return verdict;
}

}  // namespace muelle
