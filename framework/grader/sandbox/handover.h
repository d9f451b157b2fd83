#pragma once
#include "grader/sandbox/sandbox.h"

#include <initializer_list>

namespace muelle::grader {

/// Descriptors from here on carry files into a sandbox; lower ones are the confined program's.
inline constexpr int firstHandoverDescriptor = 10;

/// A file's content at its beginning, as a descriptor. Throws std::runtime_error naming the file.
Descriptor openForHandover(const VisibleFile& file);

/// `setpriv ...` when the grader is root: an unassigned user, no groups, no capability, no new privileges. Else
/// nothing.
std::vector<std::string> unprivilegedPrefix();

/// Adds words to a command line.
void append(std::vector<std::string>& command, std::initializer_list<std::string> words);

/// What can be read now and to the end of the stream, at most `bytes`, one line, for a message.
std::string readMessage(int descriptor, std::size_t bytes);

}  // namespace muelle::grader
