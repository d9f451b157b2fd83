#include "grader/matrix/corpus_share.h"

#include "base/file.h"
#include "grader/run/digest.h"

#include <fmt/format.h>
#include <algorithm>
#include <cstdlib>
#include <sstream>
#include <stdexcept>

namespace muelle::grader {

namespace {

namespace fs = std::filesystem;

constexpr const char* listName = "known.txt";
constexpr std::size_t digits = 16;  // of SHA-256: it guards against forgetting, not against forgery
constexpr const char* head =
    "# Submissions that have come out as stated: digest of the files, folder. Of these `./muelle test` takes a share;\n"
    "# what is new or changed it takes always. Written by: ./muelle test-the-tests --remember\n";

std::vector<fs::path> children(const fs::path& folder) {
  std::vector<fs::path> paths;
  for (const auto& entry : fs::directory_iterator(folder)) paths.push_back(entry.path());
  std::sort(paths.begin(), paths.end());
  return paths;
}

std::string digestOfFolder(const fs::path& folder) {
  std::string all;
  for (const fs::path& file : children(folder)) {
    all += fmt::format("{} {}\n", file.filename().string(), digestOfFile(file));
  }
  return digest({all}).substr(0, digits);
}

std::string nameIn(const fs::path& corpus, const fs::path& folder) {
  return folder.lexically_relative(corpus).generic_string();
}

std::map<std::string, std::string> readKnown(const fs::path& file) {
  std::map<std::string, std::string> known;
  if (!fs::exists(file)) return known;
  std::istringstream lines(readFile(file));
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    if (line.empty() || line.front() == '#') continue;
    const std::size_t blank = line.find(' ');
    if (blank != digits || blank + 1 == line.size()) {
      throw std::runtime_error(
          fmt::format("{}:{}: expected \"DIGEST FOLDER\"; write the list again with "
                      "./muelle test-the-tests --remember",
                      file.string(), number));
    }
    known[line.substr(blank + 1)] = line.substr(0, blank);
  }
  return known;
}

}  // namespace

CorpusShare::CorpusShare(fs::path corpus, int every)
    : corpus_(std::move(corpus)), every_(every), known_(readKnown(corpus_ / listName)) {}

bool CorpusShare::knows(const fs::path& folder) const {
  const auto known = known_.find(nameIn(corpus_, folder));
  return known != known_.end() && known->second == digestOfFolder(folder);
}

bool CorpusShare::takes(const fs::path& folder) const {
  if (!knows(folder)) return true;
  constexpr std::size_t leading = 8;  // hexadecimal digits: enough to spread names evenly
  return std::stoul(digest({nameIn(corpus_, folder)}).substr(0, leading), nullptr, 16) %
             static_cast<unsigned long>(every_) ==
         0;
}

int shareOfEnvironment() {
  const char* text = std::getenv("MUELLE_SHARE");
  if (text == nullptr) return usualShare;
  if (std::string_view(text) == "all") return 1;
  char* end = nullptr;
  const long every = std::strtol(text, &end, 10);
  if (end == text || *end != '\0' || every < 1 || every > 1000) {
    throw std::runtime_error(
        fmt::format("MUELLE_SHARE is \"{}\"; set it to \"all\" or to a number from 1 to 1000", text));
  }
  return static_cast<int>(every);
}

std::vector<fs::path> foldersIn(const fs::path& parent) {
  if (!fs::exists(parent)) return {};
  std::vector<fs::path> folders = children(parent);
  std::erase_if(folders, [](const fs::path& path) { return !fs::is_directory(path); });
  return folders;
}

std::vector<fs::path> submissionsIn(const fs::path& corpus) {
  std::vector<fs::path> found;
  for (const auto& entry : fs::recursive_directory_iterator(corpus)) {
    if (!entry.is_directory()) continue;
    const std::vector<fs::path> inside = children(entry.path());
    const bool isSubmission = !inside.empty() && std::none_of(inside.begin(), inside.end(),
                                                              [](const auto& p) { return fs::is_directory(p); });
    if (isSubmission) found.push_back(entry.path());
  }
  std::sort(found.begin(), found.end());
  return found;
}

void rememberCorpus(const fs::path& corpus, const std::vector<std::string>& topics) {
  const std::map<std::string, std::string> known = readKnown(corpus / listName);
  std::string text = head;
  for (const fs::path& folder : submissionsIn(corpus)) {
    const std::string name = nameIn(corpus, folder);
    const bool isSeen = topics.empty() || std::ranges::find(topics, name.substr(0, name.find('/'))) != topics.end();
    const auto before = known.find(name);
    if (isSeen) text += fmt::format("{} {}\n", digestOfFolder(folder), name);
    if (!isSeen && before != known.end()) text += fmt::format("{} {}\n", before->second, name);
  }
  muelle::writeFile(corpus / listName, text);
}

}  // namespace muelle::grader
