#pragma once
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <vector>

namespace muelle::bench {

/// The runs of a sweep as they are made, a line each, so that a sweep that was broken off goes on where it was: whoever
/// kills it loses the run that was under way. Lines of another program or another machine (`stamp`, the first line) are
/// thrown away, and so is a line that was cut off.
class Record {
 public:
  using Fields = std::vector<std::string>;  ///< without tabs and ends of lines

  /// Reads what is there and goes on writing. Throws std::runtime_error when the file cannot be written.
  Record(std::filesystem::path file, const std::string& stamp);

  /// The values that were kept under a key; null when there are none.
  const Fields* find(const std::string& key) const;
  /// Keeps values under a key, on the disk when it returns. Tabs and ends of lines become spaces.
  void add(const std::string& key, Fields values);
  /// How many runs were found when it began.
  std::size_t found() const { return found_; }

 private:
  std::filesystem::path file_;
  std::map<std::string, Fields> lines_;
  std::ofstream out_;
  std::size_t found_ = 0;
};

}  // namespace muelle::bench
