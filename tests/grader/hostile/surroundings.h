#pragma once
#include <filesystem>
#include <map>
#include <set>
#include <string>

namespace muelle::grader {

/// What an attack could have changed outside its sandbox, seen before and after it.
class Surroundings {
 public:
  /// \param submission the folder handed in: whole content and times are kept
  explicit Surroundings(std::filesystem::path submission);

  /// What is different now, one line each; "" when nothing is. Waits for workers that are still being ended.
  std::string changes() const;

 private:
  using Listing = std::map<std::string, std::string>;  ///< path -> size and time

  static Listing wholeFolder(const std::filesystem::path& folder);
  static std::set<std::string> names(const std::filesystem::path& folder);

  std::filesystem::path submission_;
  Listing submitted_;
  std::map<std::filesystem::path, std::set<std::string>> names_;
};

/// True for a user id that the sandbox gives away when the grader is root.
bool isUnassigned(unsigned userId);

}  // namespace muelle::grader
