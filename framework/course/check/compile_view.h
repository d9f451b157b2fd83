#pragma once
#include "course/check/dependencies.h"
#include "course/check/diagnostics.h"

#include <filesystem>
#include <string>
#include <vector>

namespace muelle {

/// A folder that shows the compiler what the grader's sandbox shows it: the student's own files, the contract and the
/// headers of the harness, each in a folder of its own. What lies beside them in the checkout is not found.
class CompileView {
 public:
  /// Makes it in `scratch`, an empty folder that outlives it.
  CompileView(std::filesystem::path scratch, const std::filesystem::path& contract,
              const std::vector<StudentFile>& files);

  /// The student's file of that name.
  std::filesystem::path source(const std::string& name) const { return scratch_ / "submission" / name; }

  /// The options that let the compiler find what it may.
  /// \param precompiled reads the precompiled header first, which only the plain flags fit
  std::vector<std::string> includeFlags(bool precompiled) const;

  CompilePlace place() const;

 private:
  std::filesystem::path scratch_;
};

}  // namespace muelle
