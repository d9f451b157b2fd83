#pragma once
#include <filesystem>
#include <optional>
#include <string>

namespace muelle::grader {

/// Which functions of a submission have run out of time, kept beside its worker, so that the other criteria that need
/// them fail at once instead of waiting again.
class TimeOutMarks {
 public:
  explicit TimeOutMarks(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// The criterion in which the function ran out of time.
  std::optional<std::string> find(const std::string& function) const;
  void add(const std::string& function, const std::string& suite) const;
  void clear() const;

 private:
  std::filesystem::path folder_;
};

}  // namespace muelle::grader
