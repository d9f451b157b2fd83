#include "grader/run/tool_watch.h"

#include "base/build_paths.h"
#include "course/check/compile_rules.h"
#include "course/check/compile_verdict.h"
#include "grader/sandbox/handover.h"

#include <sstream>
#include <string_view>

namespace muelle::grader {

namespace {

constexpr int descriptor = 4;   // in the sandbox; 3 is the list of symbols
constexpr int signalled = 128;  // a shell tells a signal as 128 + signal
constexpr std::size_t longestReport = 4096;

/// Under a linker's name it stands in that linker's place, which the driver finds by -B. The signal is passed on, so
/// that the driver says what it would have said.
constexpr const char* script = R"sh(#!/usr/bin/sh
case "$0" in
  */watch) ;;
  *) set -- "/usr/bin/${0##*/}" "$@" ;;
esac
"$@"
status=$?
echo "$status" >&4
if [ "$status" -gt 128 ]; then kill -"$((status - 128))" "$$"; fi
exit "$status"
)sh";

/// The name under which a driver looks for its linker: "ld.mold" for "-fuse-ld=mold".
std::string linkerName() {
  const std::string_view flag = build_paths::linkerFlag;
  const std::size_t sign = flag.find('=');
  return sign == std::string_view::npos ? "ld" : "ld." + std::string(flag.substr(sign + 1));
}

}  // namespace

ToolWatch::ToolWatch() : statuses_(openForHandover({})) {}

void ToolWatch::addTo(Confinement& confinement) const {
  confinement.files.push_back({"/tools/watch", {}, script, true});
  confinement.files.push_back({"/tools/ld", {}, script, true});
  if (linkerName() != "ld") confinement.files.push_back({"/tools/" + linkerName(), {}, script, true});
  confinement.descriptors[descriptor] = statuses_.get();
}

std::string ToolWatch::command() { return "../tools/watch "; }

/// Clang's driver compiles in its own process.
std::string ToolWatch::compilerFlag() { return compilesWithClang() ? "" : "-wrapper ../tools/watch "; }

std::string ToolWatch::linkerFlag() { return "-B../tools/ "; }

bool ToolWatch::sawOwnFailure() const {
  lseek(statuses_.get(), 0, SEEK_SET);
  std::istringstream statuses(readMessage(statuses_.get(), longestReport));
  bool failed = false;
  for (int status = 0; statuses >> status;) {
    if (status > signalled && isFromOutside(status - signalled)) return false;
    failed = failed || status != 0;
  }
  return failed;
}

}  // namespace muelle::grader
