/// \file
/// Writes the documentation page of the published problems: muelle-published-page FILE.

#include "base/errors.h"
#include "base/file.h"
#include "lab/published/page.h"

#include <stdexcept>

int main(int argc, char** argv) {
  return muelle::withErrorsOnOneLine([=] {
    if (argc != 2) throw std::invalid_argument("name the file to write, for example docs/published.md");
    muelle::writeFile(argv[1], muelle::published::publishedPage());
    return 0;
  });
}
