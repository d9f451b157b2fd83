#include "course/unfinished.h"

#include "base/file.h"
#include "base/text/printable.h"

#include <fmt/format.h>
#include <sstream>

namespace muelle {

std::map<std::string, std::string> unfinishedExercises(const std::filesystem::path& build) {
  std::map<std::string, std::string> unfinished;
  std::istringstream lines(tryReadFile(build / "unfinished_exercises.txt").value_or(""));
  for (std::string line; std::getline(lines, line);) {
    const std::size_t colon = line.find(": ");
    if (colon != std::string::npos) unfinished[line.substr(0, colon)] = line.substr(colon + 2);
  }
  return unfinished;
}

std::string sayUnfinished(const std::string& topic, const std::string& files) {
  return fmt::format("exercise {} is left out: it lacks {}", printableLine(topic), printableLine(files));
}

}  // namespace muelle
