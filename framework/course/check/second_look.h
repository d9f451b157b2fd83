#pragma once
/// \file
/// Which files are built once more, with sanitizers or with another fill of what was never written: those of which the
/// compiler warns, those that could keep it from warning, and those that are written in a way that it does not see
/// through. Only what the sanitizers then confirm, or an answer that depends on the fill, costs points, so that a
/// suspicion costs an honest file nothing but a second or two.

#include "course/check/compile_verdict.h"
#include "course/check/diagnostics.h"

#include <string>
#include <string_view>
#include <vector>

namespace muelle {

/// \param run of the compiler, on these files, that succeeded
bool wantsSecondLook(const ToolRun& run, const std::vector<StudentFile>& files);

/// Whether a source holds what can take a warning away or move it out of the file: a pragma, a line directive, an
/// attribute of the compiler's own, assembler.
bool mayHideWarnings(std::string_view source);

/// Whether a source names, in a way of which the compiler does not warn, what may be gone: `auto` for an arithmetic
/// expression of what functions return, a reference to what an own function of references returns, a closure that is
/// returned with references.
bool mayOutliveTemporaries(std::string_view source);

/// Whether the same tests are to be run with another fill of memory, because the compiler or the source gives reason: a
/// test that passes with one fill and fails with the other depends on what was never written, which is
/// Outcome::NeverWritten. \param run as above
bool wantsOtherFill(const ToolRun& run, const std::vector<StudentFile>& files);

/// Whether a source declares a variable without a value and does something else with it, or does so in a branch, before
/// it gives it one.
bool mayReadUnwritten(std::string_view source);

/// Why a file that was to be looked at twice is not, in a line for beside its warnings: its build with sanitizers has
/// failed. That costs nothing, since inline assembler and the like may honestly not go together with them; a source
/// cannot tell one build from the other by a macro.
std::string sayNoSecondLook(const ToolRun& run, const std::vector<StudentFile>& files);

}  // namespace muelle
