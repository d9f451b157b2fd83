#pragma once
#include "base/process/child.h"
#include "course/time_limits.h"

#include <cstddef>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace muelle {

/// Wide: the program counts its own processor time, and ends itself long before on a machine that lets it work.
constexpr int testsWallSeconds = 60;

/// Processor time [s] at which the system ends a process of the tests that has not ended itself.
constexpr unsigned testsProcessorSeconds(int callSeconds) {
  return static_cast<unsigned>(allCallsSeconds(callSeconds)) + 5;
}

constexpr std::size_t studentOutputLimit = 65536;  ///< [bytes] of what the student's code prints

/// Whether AddressSanitizer is in the program, which reserves more address space than there is memory.
enum class Instrumented { No, Yes };

/// Of the plain build: Yes in a build folder that has sanitizers everywhere.
#if defined(__SANITIZE_ADDRESS__)
constexpr Instrumented isInstrumented = Instrumented::Yes;
#else
constexpr Instrumented isInstrumented = Instrumented::No;
#endif

/// Runs a student's program without input, in the C locale; both streams together, the report apart.
/// \param callSeconds processor time that one call may take
CommandResult runStudentProgram(const std::vector<std::string>& command, Instrumented instrumented, int callSeconds);

/// True for a signal that a student's code draws by its own work. It can send itself none but abort()'s, since what
/// does so is refused; a filter of system calls around check raises SIGSYS.
bool isOwnSignal(int signal);

/// A process of the tests that has ended, and the lines of its report.
struct TestProcess {
  CommandResult result;
  std::vector<std::pair<std::string, std::string>> lines;

  /// "Suite.Name:Suite.Name"
  std::string begun() const;
  /// Whether it did not come to its end, and tests are left.
  bool leavesTests() const;
};

/// Whether it was ended from outside, perhaps, or stopped: then it is run once more.
bool isMachines(const TestProcess& process);

/// Runs the tests, and hands each process that it takes to `take`: what follows a test that ended its process runs in
/// the next, as long as they have not used up what all calls together may take.
void runTests(const std::vector<std::string>& command, Instrumented instrumented, int callSeconds,
              const std::function<void(const TestProcess&)>& take);

}  // namespace muelle
