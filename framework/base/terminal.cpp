#include "base/terminal.h"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>
#include <cstdlib>

namespace muelle {

namespace {

std::string styled(std::string_view code, std::string_view text) {
  return coloursWanted() ? fmt::format("\x1b[{}m{}\x1b[0m", code, text) : std::string(text);
}

}  // namespace

bool coloursWanted() {
  static const bool wanted = [] {
    const char* noColour = std::getenv("NO_COLOR");
    const char* term = std::getenv("TERM");
    const bool refused =
        (noColour != nullptr && *noColour != '\0') || (term != nullptr && std::string_view(term) == "dumb");
    return !refused && isatty(STDOUT_FILENO) == 1;
  }();
  return wanted;
}

std::string bold(std::string_view text) { return styled("1", text); }
std::string red(std::string_view text) { return styled("1;31", text); }
std::string green(std::string_view text) { return styled("1;32", text); }
std::string dim(std::string_view text) { return styled("2", text); }

bool isTalkedTo() { return isatty(STDIN_FILENO) == 1 && isatty(STDOUT_FILENO) == 1; }

int terminalWidth() {
  winsize size{};
  const bool known = ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
  return known ? size.ws_col : 100;
}

}  // namespace muelle
