#include "course/check/compile_rules.h"

#include "base/build_paths.h"
#include "course/check/diagnostics.h"

#include <sstream>
#include <string_view>

namespace muelle {

namespace {

void append(std::vector<std::string>& flags, const std::vector<std::string>& more) {
  flags.insert(flags.end(), more.begin(), more.end());
}

/// The compiler's own limits.
std::vector<std::string> ownLimits() {
  if (compilesWithClang()) return {"-ferror-limit=20", "-ftemplate-depth=400", "-fconstexpr-steps=10000000"};
  return {"-fmax-errors=20", "-ftemplate-depth=400", "-fconstexpr-ops-limit=10000000"};
}

/// What the second build watches: lifetimes and bounds of memory, the end of a function without return, and a bool or
/// an enum that is neither of its values: as the fill of what was never written, which else reads as false.
std::vector<std::string> sanitizers() {
  return {"-fsanitize=address", "-fsanitize=return", "-fsanitize=bool", "-fsanitize=enum"};
}

}  // namespace

std::vector<std::string> wordsOf(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> result;
  for (std::string word; stream >> word;) result.push_back(word);
  return result;
}

bool compilesWithClang() { return std::string_view(build_paths::compilerKind).ends_with("Clang"); }

std::vector<std::string> studentCompileFlags() {
  std::vector<std::string> flags = wordsOf(build_paths::studentFlags);
  append(flags, ownLimits());
  append(flags, diagnosticFlags());
  return flags;
}

std::vector<std::string> sanitizedCompileFlags() {
  std::vector<std::string> flags = studentCompileFlags();
  append(flags, sanitizers());
  // Eigen would otherwise place memory by hand that the unsanitised parts beside it give back.
  append(flags, {"-fno-sanitize-recover=all", "-fno-omit-frame-pointer", "-g1", "-DEIGEN_MALLOC_ALREADY_ALIGNED=1",
                 "-U__SANITIZE_ADDRESS__"});
  return flags;
}

std::vector<std::string> refilledCompileFlags() {
  std::vector<std::string> flags = studentCompileFlags();
  for (std::string& flag : flags) {
    if (flag == "-ftrivial-auto-var-init=pattern") flag = "-ftrivial-auto-var-init=zero";
    if (flag == "-DEIGEN_INITIALIZE_MATRICES_BY_NAN") flag = "-DEIGEN_INITIALIZE_MATRICES_BY_ZERO";
  }
  return flags;
}

std::vector<std::string> checkLinkFlags(bool sanitized) {
  std::vector<std::string> flags;
  if (*build_paths::linkerFlag != '\0') flags.emplace_back(build_paths::linkerFlag);
  flags.emplace_back("-pthread");
  if (sanitized) append(flags, sanitizers());
  return flags;
}

std::vector<std::string> symbolsCommand(const std::vector<std::string>& objects) {
  std::vector<std::string> command{"nm", "-P"};
  append(command, objects);
  return command;
}

std::vector<std::string> readParts(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> parts;
  for (std::string line; std::getline(stream, line);) {
    if (!line.empty()) parts.push_back(line);
  }
  return parts;
}

}  // namespace muelle
