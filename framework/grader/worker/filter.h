#pragma once

namespace muelle::grader::worker {

/// Before the submission is loaded: what dlopen and the message loop need, and nothing else. Any other system call
/// kills the process, but for a few that honest programs make by mistake (opening a file, starting a thread, sleeping):
/// those raise SIGSYS, so that the message can name them.
/// Prepares the running filter too, which is installed when the first instruction of the submission is about to run:
/// code that has run before a filter stands can make its installation a pretence.
/// Throws std::runtime_error when the kernel refuses.
void installLoadingFilter();

/// No more opening of files, no more executable memory, no further filter. Stacks on the first, and is tried before it
/// is believed. Throws std::runtime_error when the kernel refuses or the filter does not hold.
void installRunningFilter();

/// "openat" for its number, as text for a message; "a system call" when unknown.
const char* systemCallName(int number);

}  // namespace muelle::grader::worker
