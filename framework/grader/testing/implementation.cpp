#include "grader/testing/implementation.h"

namespace muelle::grader {

std::vector<Implementation>& implementationsOf(const std::string& exercise) {
  static std::map<std::string, std::vector<Implementation>> all;
  return all[exercise];
}

}  // namespace muelle::grader
