#include "grader/testing/call_history.h"

namespace muelle::grader {

std::map<std::string, std::unique_ptr<CallHistoryBase>>& CallHistoryBase::all() {
  static std::map<std::string, std::unique_ptr<CallHistoryBase>> histories;
  return histories;
}

}  // namespace muelle::grader
