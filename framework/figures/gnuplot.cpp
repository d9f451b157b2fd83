#include "figures/gnuplot.h"

#include "base/process/child.h"

#include <fmt/format.h>
#include <stdexcept>

namespace muelle {

namespace {

/// Long figures take seconds; a gnuplot that waits for something never ends.
constexpr std::chrono::minutes longest{5};

/// One line out of gnuplot's several.
std::string oneLine(const std::string& text) {
  std::string line;
  for (const char c : text) {
    const bool isBlank = c == '\n' || c == '\r' || c == '\t' || c == ' ';
    if (!isBlank) line += c;
    if (isBlank && !line.empty() && line.back() != ' ') line += ' ';
  }
  return line;
}

CommandResult run(const std::filesystem::path& folder, const std::vector<std::string>& scripts) {
  ChildSpec spec;
  spec.command = {"gnuplot", "-d"};  // -d: neither gnuplotrc nor ~/.gnuplot
  spec.command.insert(spec.command.end(), scripts.begin(), scripts.end());
  spec.inheritsEnvironment = true;
  spec.workingDirectory = folder.string();
  try {
    return runCommand(spec, {longest, 0, 65536, 0, false});
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(fmt::format(
        "{}; gnuplot draws the figures: install it, for example with apt install gnuplot-nox", error.what()));
  }
}

}  // namespace

void runGnuplot(const std::filesystem::path& folder, const std::vector<std::string>& scripts) {
  const CommandResult result = run(folder, scripts);
  if (!result.timedOut && result.status.success()) return;
  const std::string words = oneLine(result.err);
  const std::string how = result.timedOut           ? "did not end in time"
                          : result.status.signalled ? fmt::format("was ended by signal {}", result.status.code)
                                                    : fmt::format("failed with status {}", result.status.code);
  throw std::runtime_error(fmt::format("gnuplot {}: {}", how, words.empty() ? "it said nothing" : words));
}

}  // namespace muelle
