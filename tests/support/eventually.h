#pragma once
#include <chrono>
#include <thread>

namespace muelle {

/// Waits for what another process or thread brings about: true as soon as the condition holds, false when it does not
/// within `longest`. The only place where a test sleeps.
template <class Condition>
bool eventually(Condition holds, std::chrono::milliseconds longest = std::chrono::seconds(20)) {
  const auto deadline = std::chrono::steady_clock::now() + longest;
  while (!holds()) {
    if (std::chrono::steady_clock::now() > deadline) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return true;
}

}  // namespace muelle
