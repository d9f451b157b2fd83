#pragma once
#include <unistd.h>
#include <csignal>

namespace muelle {

/// True when another process has sent the signal: neither what this one did (a fault, a broken pipe, a limit) nor what
/// it sent to itself, as abort() does. Signal handlers use it.
inline bool wasSentByAnother(const siginfo_t& info) {
  // Linux gives what is sent a code of at most 0; macOS has numbers of its own.
  const bool wasSent = info.si_code <= 0 || info.si_code == SI_USER || info.si_code == SI_QUEUE;
  return wasSent && info.si_pid != getpid();
}

}  // namespace muelle
