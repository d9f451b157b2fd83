#pragma once
#include <filesystem>
#include <string>

namespace muelle::grader {

/// Where the grader finds its parts and keeps its products: the checkout and its build folder.
struct Workplace {
  std::filesystem::path source;
  std::filesystem::path binary;

  /// Of the build that this program belongs to.
  static Workplace ofThisBuild();

  std::filesystem::path exercises() const { return source / "exercises"; }
  std::filesystem::path contract(const std::string& topic) const {
    return source / "exercises" / topic / (topic + ".h");
  }
  std::filesystem::path harness() const { return source / "framework" / "harness"; }
  std::filesystem::path prelude() const { return binary / "prelude" / "prelude.h.gch"; }
  /// The trusted half of every worker of this exercise: dispatch table and codecs.
  std::filesystem::path glue(const std::string& topic) const { return binary / "lib" / ("libglue_" + topic + ".a"); }
  std::filesystem::path hiddenProgram(const std::string& topic) const {
    return binary / "hidden" / ("hidden_" + topic);
  }
  std::filesystem::path host() const { return binary / "bin" / "muelle-worker"; }
  std::filesystem::path stepProgram() const { return binary / "bin" / "muelle-grade-step"; }

  std::filesystem::path workers() const { return binary / "grade" / "workers"; }
  std::filesystem::path records() const { return binary / "grade" / "records"; }
  std::filesystem::path figures() const { return binary / "grade" / "figures"; }
  std::filesystem::path coreLocks() const { return binary / "grade" / "cores"; }
  std::filesystem::path seedFile() const { return binary / "grade" / "seed"; }
  std::filesystem::path ctestFile() const { return binary / "grade_tests.cmake"; }
};

}  // namespace muelle::grader
