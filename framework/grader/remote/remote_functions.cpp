#include "grader/remote/remote_functions.h"

#include "course/testing/never_written.h"

#include <algorithm>

namespace muelle::grader {

Request requestFor(const char* function, const UntypedArguments& given) {
  Request request;
  request.function = function;
  request.id = wire::functionId(function);
  request.describe = [function, given] { return printCall(function, given); };
  return request;
}

void keepCall(CallHistoryBase& history, const char* function, const UntypedArguments& given,
              std::vector<double> outcome) {
  if (std::ranges::any_of(outcome, isFill)) Session::current().noteNeverWritten(function);
  history.add(given, std::move(outcome));
}

}  // namespace muelle::grader
