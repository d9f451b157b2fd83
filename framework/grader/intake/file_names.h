#pragma once
/// \file
/// What the name of a file says: how browsers, systems and mail change the name that was asked for.

#include <string>
#include <string_view>

namespace muelle::grader {

/// True for "x.cpp", "x.cc", "x.cxx", "x.c++", "x.C", whatever the letter case, and with what browsers, editors and
/// mail put behind: "x.cpp.txt", "x.cpp.txt.txt", "x.cpp (1)", "x.cpp.1", "x.cpp.download".
bool isSourceName(std::string_view name);

/// True when `name` is `wanted` as a download, a copy or another system spells it: "spring_1d (1).cpp",
/// "spring_1d-1.cpp", "spring_1d - Copy.cpp", "Copia de spring_1d.cpp", "Spring-1D.cc", "spring_1d.cpp.txt", and any of
/// them behind Moodle's "Name Surname_12345_assignsubmission_file_". The wanted name itself is not near.
bool isNearName(const std::string& name, const std::string& wanted);

/// True for "spring_1d.txt", "spring_1d (1).txt" where "spring_1d.cpp" is wanted: the source, or a note about it.
bool isTextNamedAs(const std::string& name, const std::string& wanted);

/// True when the name without suffixes and marks of copies is the wanted one's: "spring_1d.hpp", "spring_1d.cpp.bak".
bool isNamedAlike(const std::string& name, const std::string& wanted);

/// As isNearName() for a folder and the topic that it is named after: "Spring 1D", "spring_1d (2)".
bool isNearFolderName(const std::string& name, const std::string& topic);

/// The name in lower case without its extension and without the marks of copies: "spring_1d".
std::string plainStem(const std::string& name);

/// True for the suffixes of the archives that intake reads: "x.zip", "x.tar.gz", "x.7z", whatever the letter case.
bool isArchiveName(std::string_view name);

/// "ana" for "ana.cpp" and "ana.cpp.txt"; a name that isSourceName().
std::string withoutSourceSuffix(const std::string& name);

/// "hand-in" for "hand-in.tar.gz"; other names as they are.
std::string withoutArchiveSuffix(const std::string& name);

/// ASCII letters in lower case, the rest as it is.
std::string lowerCase(std::string_view text);

}  // namespace muelle::grader
