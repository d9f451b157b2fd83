#include "grader/testing/untyped_arguments.h"

namespace muelle::grader {

std::vector<std::string> UntypedArguments::texts() const {
  std::vector<std::string> texts;
  for (const Argument& each : list) texts.push_back(each.kind->print(each.value));
  return texts;
}

std::string printCall(const std::string& function, const UntypedArguments& arguments) {
  return printCallOf(function, arguments.texts());
}

}  // namespace muelle::grader
