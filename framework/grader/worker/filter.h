#pragma once

namespace muelle::grader::worker {

/// Before the submission is loaded: what dlopen, the constructors and the message loop need, and nothing else.
/// Any other system call kills the process, but for a few that honest programs make by mistake (opening a file,
/// starting a thread, sleeping): those raise SIGSYS, so that the message can name them.
/// Throws std::runtime_error when the kernel refuses.
void installLoadingFilter();

/// After it: no more opening of files and no more executable memory. Stacks on the first.
void installRunningFilter();

/// "openat" for its number, as text for a message; "system call 999" when unknown.
const char* systemCallName(int number);

}  // namespace muelle::grader::worker
