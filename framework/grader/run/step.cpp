/// \file
/// `ctest --preset grade`: a face of the grading engine. A fixture of each exercise grades the submission named in
/// MUELLE_SUBMISSION, each other test reads what has been said of its criterion, and fails when nothing has.
///
///     muelle-grade-step grade TOPIC          grades the exercise; passes when it is built
///     muelle-grade-step read TOPIC SUITE     what was said of one criterion, or of the curves
///     muelle-grade-step ctest-file FILE      writes the tests, from the manifests
///
/// The exit status tells CTest and a reader of its log; points come from the records alone.

#include "grader/run/ctest_face.h"

#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using namespace muelle::grader;

int run(const std::vector<std::string>& arguments) {
  const Workplace workplace = Workplace::ofThisBuild();
  if (arguments.size() == 2 && arguments[0] == "ctest-file") return writeCtestFile(workplace, arguments[1]);
  if (arguments.size() == 2 && arguments[0] == "grade") return gradeForCtest(workplace, arguments[1]);
  if (arguments.size() == 3 && arguments[0] == "read") return readForCtest(workplace, arguments[1], arguments[2]);
  throw std::runtime_error("usage: muelle-grade-step grade TOPIC | read TOPIC SUITE | ctest-file FILE");
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run({argv + 1, argv + argc});
  } catch (const std::exception& error) {
    std::cout << "muelle: " << error.what() << '\n';
    return graderAtFault;
  }
}
