#pragma once
/// \file
/// What the compiler and the assembler have read to make a student's file. Whatever way a file has come in (a header
/// beside it, a whole path, a package of this machine, an assembler's .incbin), the list has it, so that `check` and
/// `grade` refuse the same in the same words.

#include "course/check/compile_verdict.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace muelle {

/// Compiler options that write the lists dependencyLists() of an object.
std::vector<std::string> dependencyFlags(const std::string& object);

/// The lists: the compiler's and, where there is one that writes it, the assembler's.
std::vector<std::string> dependencyLists(const std::string& object);

/// The files in lists as make reads them, targets apart: "a.o: a.cpp /usr/include/c++/12/vector".
std::vector<std::string> readDependencies(std::string_view lists);

/// Whether the file belongs to the standard library, to the compiler or to the system's C library; false for a package
/// that happens to be installed (<fmt/format.h>).
bool isStandardHeader(const std::filesystem::path& file);

/// Where a compilation took place, as the compiler was told.
struct CompilePlace {
  std::filesystem::path folder;                ///< in which it ran
  std::vector<std::filesystem::path> visible;  ///< folders whose files may be read, beside the standard library's
};

/// Passed, or Compile with the first file that is not there when the hand-in is graded.
/// \param files the student's
CompileVerdict judgeDependencies(std::string_view lists, const CompilePlace& place,
                                 const std::vector<StudentFile>& files);

}  // namespace muelle
