#include "app/errors.h"

#include "harness/text/printable.h"

#include <fmt/format.h>
#include <algorithm>
#include <cstdio>
#include <exception>
#include <string>

namespace muelle::app {

namespace {

/// Errors take one line, whatever they quote.
std::string oneLine(std::string text) {
  std::ranges::replace(text, '\n', ' ');
  return printable(text);
}

}  // namespace

int withErrorsOnOneLine(const std::function<int()>& body) {
  try {
    return body();
  } catch (const std::exception& error) {
    fmt::print(stderr, "muelle: {}\n", oneLine(error.what()));
    return 2;
  }
}

}  // namespace muelle::app
