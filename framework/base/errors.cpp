#include "base/errors.h"

#include "base/text/printable.h"

#include <fmt/format.h>
#include <cstdio>
#include <exception>
#include <string>

namespace muelle {

namespace {

/// An error takes one line, whatever it quotes.
std::string oneLine(std::string text) {
  for (char& c : text) {
    if (c == '\n') c = ' ';
  }
  return text;
}

}  // namespace

int withErrorsOnOneLine(const std::function<int()>& body) {
  try {
    return body();
  } catch (const std::exception& error) {
    fmt::print(stderr, "muelle: {}\n", printableLine(oneLine(error.what())));
    return 2;
  }
}

}  // namespace muelle
