#pragma once

namespace muelle {

/// Makes a write that fails an error to be told: a closed pipe and a limit of file sizes do not end the process any
/// more. A standard stream that was closed gets a stand-in, so that no file is opened in its place and written to by
/// mistake; writing to standard output fails then.
void guardStandardStreams();

/// Writes what is still buffered. Throws std::runtime_error with the system's reason when something that was printed to
/// standard output has not got there.
void finishStandardOutput();

/// True when something that was printed to standard output was refused.
bool standardOutputFailed();

}  // namespace muelle
