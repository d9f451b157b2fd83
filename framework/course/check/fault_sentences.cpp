#include "course/check/fault_sentences.h"

#include "base/text/printable.h"

#include <fmt/format.h>
#include <csignal>

namespace muelle {

const char* signalSentence(int signal) {
  switch (signal) {
    case SIGSEGV:
    case SIGBUS:
      return badMemorySentence;
    case SIGFPE:
      return divisionSentence;
    case SIGILL:
    case SIGTRAP:
      return nowhereSentence;
    case SIGABRT:
      return abortSentence;
    default:
      return nullptr;
  }
}

std::string limitSentence(std::chrono::milliseconds limit) {
  return fmt::format("did not return within {} s of processor time", static_cast<double>(limit.count()) / 1000.0);
}

std::string exitSentence(int code) {
  constexpr unsigned kept = 0xFF;
  return fmt::format("ended the program with exit({}) instead of returning", static_cast<unsigned>(code) & kept);
}

std::string uncaughtSentence(std::string_view text) {
  constexpr std::size_t longest = 480;
  if (text.empty()) return "threw an exception that nobody caught, and that has no text";
  return "threw an exception that nobody caught: " + cut(printableLine(text), longest);
}

}  // namespace muelle
