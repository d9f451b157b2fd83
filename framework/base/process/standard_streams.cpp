#include "base/process/standard_streams.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <stdexcept>
#include <string>

namespace muelle {

void guardStandardStreams() {
  for (const int ignored : {SIGPIPE, SIGXFSZ}) signal(ignored, SIG_IGN);
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (fcntl(stream, F_GETFD) >= 0 || errno != EBADF) continue;
    // The lowest free number is the stream's. Standard output cannot be written, for nobody will read it.
    [[maybe_unused]] const int standIn = open("/dev/null", stream == STDOUT_FILENO ? O_RDONLY : O_RDWR);
  }
}

void finishStandardOutput() {
  errno = 0;
  const bool failed = std::fflush(stdout) != 0 || standardOutputFailed();
  if (!failed) return;
  const std::string reason = errno != 0 ? fmt::format(": {}", std::strerror(errno)) : "";
  throw std::runtime_error("cannot write to the standard output" + reason);
}

bool standardOutputFailed() { return std::ferror(stdout) != 0; }

}  // namespace muelle
