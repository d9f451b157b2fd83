#pragma once

namespace muelle {

// Processor time that a student's code may take [s], in check as in grade. An exercise whose functions have much to do
// says so in its manifest: call_seconds = 15.

inline constexpr int usualCallSeconds = 2;
inline constexpr int longestCallSeconds = 20;  ///< what hangs is ended after that at the latest

/// All calls that one process makes.
constexpr int allCallsSeconds(int callSeconds) { return callSeconds + 8; }

}  // namespace muelle
