#pragma once
#include "course/check/diagnostics.h"
#include "course/check/outcome.h"
#include "course/manifest.h"

#include <filesystem>
#include <string>
#include <vector>

namespace muelle {

/// Where the check finds the course and what CMake has built of it.
struct CheckFolders {
  std::filesystem::path exercises;  ///< exercises/
  std::filesystem::path build;      ///< the build folder: check/TOPIC.parts lists what a student's file is linked with
  std::filesystem::path out;        ///< curves go to out/TOPIC/
};

/// The folders of this checkout.
CheckFolders checkFolders();

/// A student's file, compiled and linked with the public tests and the demo of its exercise.
struct StudentProgram {
  std::filesystem::path executable;   ///< empty when it could not be built
  std::string diagnostics;            ///< errors, or warnings when it was built; for the terminal
  std::string fingerprint;            ///< tells one state of all its sources from another
  Outcome outcome = Outcome::Passed;  ///< Compile, Link, Forbidden, Cpu, ... when it could not be built
  std::string message;                ///< why, in one line: the grader's words
  std::string note;                 ///< what was done to read its text: "spring_3d.cpp: converted from UTF-16"; else ""
  std::filesystem::path sanitized;  ///< the second build, which a warning of its kinds starts; else empty
  /// The same with another fill of what was never written, where there is reason for it.
  std::filesystem::path refilled;
  std::vector<StudentFile> students;   ///< its sources
  int callSeconds = usualCallSeconds;  ///< processor time that one call may take [s]
};

/// Compiles and links, unless the program of these very sources stands there already. Two may run at once.
/// \param sources the files of the manifest, in its order
/// Throws std::runtime_error when a file or a part that the build should have made is missing, and when the machine is
/// to blame: then nothing is said about the student's file.
StudentProgram buildStudentProgram(const Manifest& manifest, const std::vector<std::filesystem::path>& sources,
                                   const CheckFolders& folders);

}  // namespace muelle
