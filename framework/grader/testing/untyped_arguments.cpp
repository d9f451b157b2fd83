#include "grader/testing/untyped_arguments.h"

namespace muelle::grader {

std::string printCall(const std::string& function, const UntypedArguments& arguments) {
  std::string text;
  for (const Argument& each : arguments.list) text += (text.empty() ? "" : ", ") + each.kind->print(each.value);
  return function + "(" + text + ")";
}

}  // namespace muelle::grader
