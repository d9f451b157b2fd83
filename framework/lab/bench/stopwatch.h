#pragma once
#include <functional>

namespace muelle::bench {

/// Now, in seconds from some moment on; a test passes one of its own.
using Clock = std::function<double()>;

/// The processor time that this process has had: what else runs on the machine is not in it, though caches and clock
/// rate feel it.
double processorTime();

/// Seconds that a call of `work` takes: calls it until `least` seconds have passed, at least once, and divides. Between
/// two looks at the clock it calls it as often as before, so that the looks cost nothing: at most 2 `least` pass, or
/// one call.
double secondsOf(const std::function<void()>& work, const Clock& now, double least);

}  // namespace muelle::bench
