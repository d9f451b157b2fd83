#include "course/check/compile_rules.h"

#include "base/build_paths.h"
#include "course/check/diagnostics.h"

#include <sstream>

namespace muelle {

namespace {

std::vector<std::string> words(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> result;
  for (std::string word; stream >> word;) result.push_back(word);
  return result;
}

}  // namespace

std::vector<std::string> studentCompileFlags() {
  std::vector<std::string> flags = words(build_paths::studentFlags);
  for (const std::string& flag : diagnosticFlags()) flags.push_back(flag);
  // The compiler's own limits, so that a template or constexpr bomb ends early with words instead of by force.
  for (const char* flag : {"-fmax-errors=20", "-ftemplate-depth=400"}) flags.emplace_back(flag);
  return flags;
}

std::vector<std::string> sanitisedCompileFlags() {
  std::vector<std::string> flags = studentCompileFlags();
  for (const char* flag : {"-fsanitize=address", "-fsanitize=return", "-fno-omit-frame-pointer"})
    flags.emplace_back(flag);
  return flags;
}

std::vector<std::string> sanitisedLinkFlags() { return {"-fsanitize=address", "-fsanitize=return"}; }

}  // namespace muelle
