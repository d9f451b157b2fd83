/// \file
/// Writes the documentation page of the methods: muelle-methods-page FILE.

#include "base/file.h"
#include "engine/integrators/methods_page.h"

#include <fmt/format.h>
#include <cstdio>
#include <exception>

int main(int argc, char** argv) {
  if (argc != 2) {
    fmt::print(stderr, "muelle-methods-page: name the file to write, for example docs/methods.md\n");
    return 2;
  }
  try {
    muelle::writeFile(argv[1], muelle::engine::methodsPage());
  } catch (const std::exception& error) {
    fmt::print(stderr, "muelle-methods-page: {}\n", error.what());
    return 2;
  }
  return 0;
}
