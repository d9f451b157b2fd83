/// \file
/// write_scaffold TOPIC FOLDER: what `muelle new TOPIC` would write into this checkout, in a course of its own, so that
/// it is built and graded without a trace in the checkout.

#include "base/build_paths.h"
#include "base/file.h"
#include "grader/authoring/scaffold.h"

#include <cstdio>
#include <exception>

int main(int argc, char** argv) {
  namespace fs = std::filesystem;
  if (argc != 3) return 2;
  try {
    const fs::path folder = argv[2];
    for (const auto& [file, text] : muelle::grader::scaffoldOf(muelle::build_paths::source, argv[1])) {
      fs::create_directories((folder / file).parent_path());
      muelle::writeFile(folder / file, text);
    }
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
