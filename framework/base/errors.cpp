#include "base/errors.h"

#include "base/process/standard_streams.h"
#include "base/text/printable.h"

#include <fmt/format.h>
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

}  // namespace

int withErrorsOnOneLine(const std::function<int()>& body) {
  guardStandardStreams();
  try {
    const int code = body();
    finishStandardOutput();
    return code;
  } catch (const std::exception& error) {
    // Not by fmt, which throws where this stream cannot be written either.
    std::fputs(("muelle: " + wordsOf(error) + "\n").c_str(), stderr);
    return 2;
  }
}

}  // namespace muelle
