#pragma once
#include "course/check/compile_rules.h"

#include <chrono>
#include <filesystem>
#include <string>

namespace muelle::grader {

/// Where the grader finds its parts and keeps its products: the checkout and its build folder. The programs are
/// members, so that a test can put a broken one in a program's place.
struct Workplace {
  std::filesystem::path source;
  std::filesystem::path binary;
  std::filesystem::path kept;      ///< what is kept between runs: build/grade, or the folder that MUELLE_KEPT names
  std::filesystem::path compiler;  ///< for the students' files
  std::filesystem::path host;      ///< the program that loads a student's code
  std::filesystem::path sanitisedHost;
  CompileLimits limits;
  /// Whether what a compiled file uses is judged before it runs; false where a test asks if the sandbox holds alone.
  bool judgesSymbols = true;
  /// Wide limits of wall time: passing one is the machine's fault, never the student's.
  std::chrono::milliseconds criterionWall{std::chrono::minutes(5)};
  std::chrono::milliseconds callWall{std::chrono::seconds(30)};

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
  /// The solution, compiled as a student's file is.
  std::filesystem::path reference(const std::string& topic) const {
    return binary / "lib" / ("reference_" + topic + ".o");
  }
  std::filesystem::path hiddenProgram(const std::string& topic) const {
    return binary / "hidden" / ("hidden_" + topic);
  }

  std::filesystem::path objects() const { return kept / "objects"; }
  std::filesystem::path records() const { return kept / "records"; }
  std::filesystem::path work() const { return kept / "work"; }  ///< a folder for each program that runs now
  std::filesystem::path coreLocks() const { return kept / "cores"; }
  std::filesystem::path seedFile() const { return kept / "seed"; }
};

}  // namespace muelle::grader
