#include "base/errors.h"

#include "base/process/standard_streams.h"
#include "base/text/printable.h"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <cstdio>
#include <exception>
#include <stdexcept>
#include <string>
#include <system_error>

namespace muelle {

namespace {

/// An error takes one line, whatever it quotes.
std::string oneLine(std::string text) {
  for (char& c : text) {
    if (c == '\n') c = ' ';
  }
  return text;
}

/// What to say of an error. When the output has been refused, the library that prints says so in words of its own.
std::string wordsOf(const std::exception& error) {
  const auto* ofSystem = dynamic_cast<const std::system_error*>(&error);
  if (ofSystem != nullptr && standardOutputFailed()) {
    return "cannot write to the standard output: " + ofSystem->code().message();
  }
  return printableLine(oneLine(error.what()));
}

/// True for what a wrong name is answered with, and no machine that is well avoids.
bool isOfAName(const std::error_code& code) {
  constexpr std::array answers{
      std::errc::no_such_file_or_directory, std::errc::not_a_directory,  std::errc::is_a_directory,
      std::errc::filename_too_long,         std::errc::invalid_argument, std::errc::too_many_symbolic_link_levels};
  return std::ranges::any_of(answers, [&code](std::errc answer) { return code == answer; });
}

int tell(const std::exception& error, int code) {
  // Not by fmt, which throws where this stream cannot be written either.
  std::fputs(("muelle: " + wordsOf(error) + "\n").c_str(), stderr);
  return code;
}

}  // namespace

int blamingTheMachine(const std::function<int()>& body) {
  try {
    return body();
  } catch (const std::system_error& error) {
    if (isOfAName(error.code()) || standardOutputFailed()) throw;
    throw MachineFault(error.what());
  }
}

int withErrorsOnOneLine(const std::function<int()>& body) {
  guardStandardStreams();
  try {
    const int code = body();
    finishStandardOutput();
    return code;
  } catch (const MachineFault& error) {
    return tell(error, 1);
  } catch (const std::exception& error) {
    return tell(error, 2);
  }
}

}  // namespace muelle
