#include "grader/run/time_out_marks.h"

#include "base/file.h"
#include "grader/record.h"

namespace muelle::grader {

namespace {
constexpr const char* prefix = "timeout.";
}

std::optional<std::string> TimeOutMarks::find(const std::string& function) const {
  const std::filesystem::path file = folder_ / (prefix + function);
  if (!std::filesystem::exists(file)) return std::nullopt;
  return readFile(file);
}

void TimeOutMarks::add(const std::string& function, const std::string& suite) const {
  if (!find(function)) writeFile(folder_ / (prefix + function), suite);
}

void TimeOutMarks::clear() const {
  if (!std::filesystem::exists(folder_)) return;
  for (const auto& entry : std::filesystem::directory_iterator(folder_)) {
    if (entry.path().filename().string().starts_with(prefix)) std::filesystem::remove(entry.path());
  }
}

}  // namespace muelle::grader
