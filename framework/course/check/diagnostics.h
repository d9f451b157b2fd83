#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace muelle {

/// A file of the student: the only one that a diagnostic quotes.
struct StudentFile {
  std::string name;  ///< without folders: "spring_3d.cpp"
  std::string text;
};

/// One thing to mend.
struct Diagnostic {
  bool isError = true;      ///< false: a warning
  std::string file;         ///< without folders
  int line = 0;             ///< from 1; 0 when unknown
  int column = 0;           ///< in bytes from 1; 0 when unknown
  std::string message;      ///< the compiler's, with the types under the course's names
  std::string explanation;  ///< what it means and what to do; "" when the message says it
  std::string option;       ///< that switches the warning: "-Wuninitialized"; "" for an error
};

/// Compiler options whose words parseDiagnostics() reads best; it copes with others. LC_ALL=C is assumed.
std::vector<std::string> diagnosticFlags();

/// The errors in the student's lines (also those that arise inside Eigen, at the student's line that led there), one a
/// line of theirs; when there is none, the warnings in them.
/// \param compilerText what g++ or clang++ wrote   \param files the student's
std::vector<Diagnostic> parseDiagnostics(std::string_view compilerText, const std::vector<StudentFile>& files);

/// As text: each with its line of source and a caret, at most `limit` of them, escaped for a terminal.
std::string showDiagnostics(const std::vector<Diagnostic>& diagnostics, const std::vector<StudentFile>& files,
                            int limit = 3);

/// parseDiagnostics() and showDiagnostics(). When nothing stands in the student's lines, the first error there is.
std::string cutDiagnostics(std::string_view compilerText, const std::vector<StudentFile>& files);

/// Whether a warning in the student's lines tells of memory that is gone, was never written or is not theirs, or of a
/// missing return: reason to build once more with sanitizers (second_look.h), since a warning alone costs nothing.
bool warnsOfMemory(std::string_view compilerText, const std::vector<StudentFile>& files);

/// Whether one of these tells of what was never written.
bool warnsOfUnwritten(std::string_view compilerText, const std::vector<StudentFile>& files);

/// The functions and variables that the linker's complaints are about, each once and without namespace, class,
/// arguments: {"springForce", "main"}.
std::vector<std::string> linkedNames(std::string_view linkerText);

/// What the linker's complaints mean: a function of the contract that is missing, misspelt or of another signature, a
/// function declared and never written, a second main.
/// \param contract text of TOPIC.h   \param contractName "spring_3d.h"
std::string explainLinkErrors(std::string_view linkerText, const std::vector<StudentFile>& files,
                              std::string_view contract, std::string_view contractName);

}  // namespace muelle
