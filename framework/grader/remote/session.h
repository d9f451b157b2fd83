#pragma once
#include "course/check/outcome.h"
#include "course/testing/random.h"
#include "grader/remote/fault.h"
#include "grader/remote/worker_process.h"
#include "grader/wire/frame.h"

#include <functional>
#include <map>
#include <memory>
#include <set>
#include <span>
#include <string>
#include <vector>

namespace muelle::grader {

/// A function of the test that the student's code may call during one call.
using CallbackHandler = std::function<std::vector<std::byte>(std::span<const std::byte> arguments)>;

/// One call, ready to be sent.
struct Request {
  std::string function;
  std::uint32_t id = 0;
  std::vector<std::byte> arguments;
  std::vector<CallbackHandler> callbacks;
  std::function<std::string()> describe;  ///< the call as source
};

/// The conversation of one test process with one worker.
///
/// Some calls are repeated later, out of order, with their old arguments: an answer that has changed is a fault, so
/// counting calls or remembering answers earns nothing. After a fault every further call of that function fails with
/// the same words; the other functions go on in a fresh worker, unless the fault was one of the machine's, of memory,
/// or a forbidden call: then nothing is called any more.
class Session {
 public:
  struct Setup {
    const Sandbox* sandbox = nullptr;
    std::filesystem::path host;
    std::filesystem::path submission;
    std::uint64_t seed = 0;  ///< of the choice of repeated calls
    SessionLimits limits;
    bool sanitised = false;  ///< `host` is the one linked with AddressSanitizer
    bool refilled = false;   ///< the submission is the one with the other fill; the heap has it, too
  };

  explicit Session(Setup setup);

  /// The session of this process; GraderFault when there is none.
  static Session& current();
  static void setCurrent(Session* session);

  /// Performs a call. Throws SubmissionFault or GraderFault.
  std::vector<std::byte> call(const Request& request);

  /// The next call is the first one of a new process: a function that keeps something of earlier calls answers
  /// otherwise.
  void startAfresh() { needsFreshWorker_ = true; }

  /// Notes a fault of the function that was called last: an answer that cannot be read.
  [[noreturn]] void fail(const SubmissionFault& fault);

  /// The first one, or the one that ended everything.
  const std::string& fault() const { return fault_; }
  /// Whether a call has failed since forgetLastCall(): the test is over, whatever it says.
  bool hasFailed() const { return hasFailed_; }
  /// The functions that were called since forgetLastCall().
  const std::set<std::string>& called() const { return called_; }
  /// The functions whose earlier answers are not believed: asked again, they answered otherwise, or not at all.
  const std::set<std::string>& unreliable() const { return unreliable_; }
  /// The class of the fault; Outcome::Passed when there is none.
  Outcome outcome() const { return outcome_; }
  /// Whether the fault is what a sanitizer has found, of the kinds that the second look is made for.
  bool isConfirmed() const { return isConfirmed_; }
  /// The first function that returned memory to which nothing was written; "" when none did.
  const std::string& neverWritten() const { return neverWritten_; }
  void noteNeverWritten(const std::string& function) {
    if (neverWritten_.empty()) neverWritten_ = function;
  }
  const std::string& graderFault() const { return graderFault_; }
  /// Stands for the code that runs when a file is loaded, which every function needs.
  static constexpr const char* loading = "(loading)";
  /// The function that used up its processor time or waits without end, `loading`, or "". Not one that was held up by
  /// the machine.
  const std::string& timedOutFunction() const { return timedOutFunction_; }
  std::string lastCall() const { return describeLast_ ? describeLast_() : std::string(); }
  /// Forgets the last call, so that a test's failure does not show the call of another.
  void forgetLastCall() {
    describeLast_ = nullptr;
    hasFailed_ = false;
    called_.clear();
  }
  std::string output() const { return earlierOutput_ + (worker_ ? worker_->output() : std::string()); }
  long calls() const { return calls_; }
  /// Process id of the sandbox, 0 when no worker runs.
  pid_t workerPid() const { return worker_ ? worker_->pid() : 0; }
  /// Process id of the program that has loaded the student's code.
  pid_t hostPid() const { return worker_ ? worker_->hostPid() : 0; }

  /// A callback that threw in the test process: kept, so that it is not blamed on the student.
  void noteGraderFault(const std::string& what) { graderFault_ = what; }

 private:
  struct PastCall {
    Request request;
    std::vector<std::byte> reply;
  };

  std::vector<std::byte> exchange(const Request& request);
  void startWorker();
  void note(const SubmissionFault& fault, const std::string& function);
  void noteEndOfWorker(SubmissionFault fault, const std::string& function);
  SubmissionFault inItsTime(const SubmissionFault& fault, const std::string& function);
  std::vector<std::byte> converse(const Request& request, const Patience& patience);
  void answerCallback(const Request& request, const wire::Frame& frame, std::uint64_t nonce, const Patience& patience);
  void remember(const Request& request, const std::vector<std::byte>& reply);
  void repeatAnEarlierCall(const std::string& current);
  bool answersAsBefore(const PastCall& past);

  Setup setup_;
  Random random_;
  std::unique_ptr<WorkerProcess> worker_;
  std::vector<PastCall> past_;
  std::function<std::string()> describeLast_;
  std::chrono::nanoseconds cpuUsed_{0};
  std::chrono::nanoseconds cpuBefore_{0};  ///< of this worker, when the last call began
  std::string fault_;
  Outcome outcome_ = Outcome::Passed;
  bool isConfirmed_ = false;
  std::string graderFault_;
  std::string neverWritten_;
  std::string timedOutFunction_;
  std::map<std::string, SubmissionFault> broken_;  ///< what every further call of a function says
  std::set<std::string> unreliable_;
  std::set<std::string> called_;
  std::string lastFunction_;
  std::string earlierOutput_;  ///< of workers that have ended
  bool needsFreshWorker_ = false;
  bool hasFailed_ = false;
  bool isOver_ = false;
  long calls_ = 0;
};

}  // namespace muelle::grader
