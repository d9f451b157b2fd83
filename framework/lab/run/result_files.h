#pragma once
#include "harness/figure.h"

#include <filesystem>
#include <string>
#include <vector>

namespace muelle::lab {

/// Where a command puts what it makes of a scene; names each file on a line of the summary.
class ResultFiles {
 public:
  /// Makes the folder where it is not there. \param folder  empty: out/SCENE
  ResultFiles(const std::string& folder, const std::string& scene);

  const std::filesystem::path& folder() const { return folder_; }
  /// Writes the figures and names the SVG file of each.
  void draw(const std::vector<Figure>& figures) const;
  /// Names a table that has been written.
  static void nameTable(const std::filesystem::path& file);

 private:
  std::filesystem::path folder_;
};

}  // namespace muelle::lab
