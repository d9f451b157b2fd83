#pragma once
/// \file
/// How a student's file is compiled and linked, and within which limits: one place for `check` and `grade`.

#include <chrono>
#include <cstddef>
#include <string>
#include <vector>

namespace muelle {

/// What compiling or linking one submission may cost. Processor time costs points; wall time is the machine's word.
struct CompileLimits {
  std::chrono::seconds processorTime{20};  ///< of each process of the compiler; ended by SIGXCPU
  std::chrono::seconds wall{120};          ///< wide: whoever passes it has waited, not worked
  std::size_t memory = 2UL << 30U;         ///< address space [bytes]; macOS knows no such limit
  std::size_t words = 64UL << 10U;         ///< kept of what the compiler says [bytes]
  std::size_t product = 64UL << 20U;       ///< of the compiled file [bytes]
};

/// The words of a command line that are separated by blanks.
std::vector<std::string> wordsOf(const std::string& text);

/// Language, optimisation, warnings, the fill of uninitialised memory; the compiler's own limits, so that a template or
/// constexpr bomb ends early with words instead of by force; and how its words are to be laid out.
std::vector<std::string> studentCompileFlags();

/// The same for the second build, which a warning starts (second_look.h): AddressSanitizer, and a trap where a function
/// ends without return. No precompiled header fits these flags, and no macro tells a source that it is compiled so.
std::vector<std::string> sanitizedCompileFlags();

/// The same as the plain flags but for the fill of what was never written, which is zero (for local numbers see
/// withFilledNumbers()). No precompiled header fits
/// these, either.
std::vector<std::string> refilledCompileFlags();

/// How many times the processor and wall time of the plain build the second look may take, and how many times its
/// stack.
inline constexpr unsigned sanitizedFactor = 4;
inline constexpr unsigned sanitizedStackFactor = 8;

/// Flags with which the checking program is linked, libraries apart. \param sanitized as of the second build
std::vector<std::string> checkLinkFlags(bool sanitized);

/// "nm -P OBJECTS": the command whose words readSymbols() understands.
std::vector<std::string> symbolsCommand(const std::vector<std::string>& objects);

/// True when the students' files are compiled by clang (Apple's too, whatever its name), which spells some flags
/// otherwise.
bool compilesWithClang();

/// The arguments of the linker in a list of parts (build/check/TOPIC.parts): one a line, as it is, so that a path may
/// hold blanks, quotes and backslashes.
std::vector<std::string> readParts(const std::string& text);

}  // namespace muelle
