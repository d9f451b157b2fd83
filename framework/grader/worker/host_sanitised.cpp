/// \file
/// What the host that is linked with AddressSanitizer adds: a finding ends the process with a frame that names it. No
/// report is printed, so that it needs no further system call and no student's output can look like one.

#include "grader/worker/death.h"
#include "grader/worker/sanitised.h"

#include <sanitizer/asan_interface.h>
#include <cstdint>
#include <cstdio>
#include <cstring>

namespace {

/// Where -fsanitize=return found the end of a function, as the compiler lays it out.
struct SourceLocation {
  const char* file;
  std::uint32_t line;
  std::uint32_t column;
};
struct MissingReturn {
  SourceLocation location;
};
/// Where -fsanitize=bool,enum found a value that is none; what follows in the compiler's layout is of no use here.
struct InvalidValue {
  SourceLocation location;
};

/// "sanitizer heap-buffer-overflow"
[[noreturn]] void dieOf(const char* finding) {
  static char text[300];  // the heap may be what is broken
  std::snprintf(text, sizeof text, "%s%s", muelle::grader::worker::sanitiserFinding, finding);
  muelle::grader::worker::dieSaying(text);
}

const char* fileName(const char* path) {
  const char* slash = std::strrchr(path, '/');
  return slash != nullptr ? slash + 1 : path;
}

/// "sanitizer missing-return spring_3d.cpp:26"
[[noreturn]] void dieAt(const char* finding, const SourceLocation& location) {
  char text[250];
  std::snprintf(text, sizeof text, "%s %s:%u", finding, fileName(location.file), location.line);
  dieOf(text);
}

}  // namespace

extern "C" {

__attribute__((visibility("default"))) const char* __asan_default_options() {
  return "detect_leaks=0:symbolize=0:color=never:log_path=stderr:exitcode=3:detect_stack_use_after_return=1:"
         "allocator_may_return_null=0:max_allocation_size_mb=1024:max_malloc_fill_size=4096:handle_segv=0:"
         "handle_sigbus=0:handle_sigfpe=0:handle_abort=0:use_sigaltstack=0:check_initialization_order=0";
}

/// Called when something has been found, before anything is printed.
__attribute__((visibility("default"))) void __asan_on_error() { dieOf(__asan_get_report_description()); }

// The sanitizers call what follows by these names.
// NOLINTBEGIN(bugprone-reserved-identifier)

/// In place of UndefinedBehaviorSanitizer's, which prints and ends the process.
__attribute__((visibility("default"))) void __ubsan_handle_missing_return(const MissingReturn* where) {
  dieAt("missing-return", where->location);
}

/// In place of UndefinedBehaviorSanitizer's, too.
__attribute__((visibility("default"))) void __ubsan_handle_load_invalid_value_abort(const InvalidValue* where,
                                                                                    std::uintptr_t /*value*/) {
  dieAt("invalid-value", where->location);
}
// NOLINTEND(bugprone-reserved-identifier)
}
