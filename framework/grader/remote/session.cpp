#include "grader/remote/session.h"

#include "course/check/eigen_message.h"
#include "course/check/fault_sentences.h"
#include "course/check/missing_functions.h"
#include "course/check/standard_message.h"
#include "course/check/thrown_sentence.h"
#include "course/testing/never_written.h"
#include "course/testing/test_function.h"
#include "grader/remote/fault.h"
#include "grader/worker/glue.h"

#include <fmt/format.h>
#include <random>
#include <sstream>
#include <string_view>

namespace muelle::grader {

namespace {

Session* theSession = nullptr;

constexpr int repeatOneIn = 8;
constexpr std::size_t rememberedCalls = 256;
constexpr std::size_t largestRemembered = 256 * 1024;  // [bytes]; a submission decides how large its answers are

std::uint64_t freshNonce() {
  static std::random_device device;  // the kernel's randomness: the worker cannot foresee it
  return (static_cast<std::uint64_t>(device()) << 32) | device();
}

/// "condition, function, index" by lines, as the worker sends an assertion of Eigen or of the standard library.
SubmissionFault refusal(const wire::Frame& frame, const std::string& function) {
  std::istringstream lines(wire::shortTextOf(frame));
  std::string condition;
  std::string where;
  std::string index;
  std::getline(lines, condition);
  std::getline(lines, where);
  std::getline(lines, index);
  if (where == missingFunction) return SubmissionFault(condition, Outcome::Link);
  AssertedIndex asserted;
  if (!index.empty() && index.size() < 12) asserted = AssertedIndex(std::strtol(index.c_str(), nullptr, 10));
  if (where.starts_with(worker::standardLibrary)) {
    where.erase(0, std::string_view(worker::standardLibrary).size());
    return SubmissionFault(fmt::format("{} {}", function, standardMessage(condition, where)), Outcome::Crash);
  }
  if (asserted.known && isFillInteger(asserted.value)) {
    return SubmissionFault(
        fmt::format("an index was never written in {}: give every variable a value before it is read", function),
        Outcome::NeverWritten);
  }
  return SubmissionFault(eigenMessage(condition, where, asserted, function), Outcome::Crash);
}

}  // namespace

Session::Session(Setup setup) : setup_(std::move(setup)), random_(setup_.seed) {}

Session& Session::current() {
  if (theSession == nullptr) throw GraderFault("a hidden test called a submission outside a session");
  return *theSession;
}

void Session::setCurrent(Session* session) { theSession = session; }

std::vector<std::byte> Session::call(const Request& request) {
  describeLast_ = request.describe;
  called_.insert(request.function);
  std::vector<std::byte> reply = exchange(request);
  if (request.callbacks.empty()) {
    remember(request, reply);
    if (!past_.empty() && random_.integer(1, repeatOneIn) == 1) repeatAnEarlierCall(request.function);
  }
  return reply;
}

void Session::fail(const SubmissionFault& fault) {
  note(fault, lastFunction_);
  if (worker_) worker_->end();  // what else it sends cannot be told from an answer
  needsFreshWorker_ = true;
  throw fault;
}

std::vector<std::byte> Session::exchange(const Request& request) {
  lastFunction_ = request.function;
  if (!graderFault_.empty()) throw GraderFault(graderFault_);
  const auto broken = broken_.find(request.function);
  if (isOver_ || broken != broken_.end()) {
    hasFailed_ = true;
    throw isOver_ ? SubmissionFault(fault_, outcome_) : broken->second;
  }
  ++calls_;
  try {
    startWorker();
    const std::chrono::nanoseconds left = setup_.limits.criterion - cpuUsed_;
    cpuBefore_ = worker_->cpu();
    const Patience patience =
        worker_->patience(std::min<std::chrono::nanoseconds>(setup_.limits.call, left), setup_.limits.callWall);
    std::vector<std::byte> reply = converse(request, patience);
    const std::chrono::nanoseconds after = worker_->cpu();
    // Between two looks it may have passed the limit: the verdict must not depend on when we looked.
    if (after > patience.cpu) throw SubmissionFault(request.function + " used up its processor time", Outcome::Cpu);
    cpuUsed_ += after - cpuBefore_;
    return reply;
  } catch (const SubmissionFault& fault) {
    noteEndOfWorker(fault, request.function);
    throw SubmissionFault(broken_.contains(request.function) ? broken_.at(request.function)
                                                             : SubmissionFault(fault_, outcome_));
  } catch (const GraderFault& error) {
    graderFault_ = error.what();
    throw;
  }
}

namespace {

/// Whether the other functions may be asked all the same.
bool concernsOneFunction(const SubmissionFault& fault) {
  const Outcome outcome = fault.outcome();
  const bool isOfOne =
      outcome == Outcome::Wrong || outcome == Outcome::Crash || outcome == Outcome::Cpu || outcome == Outcome::Link;
  return isOfOne && !fault.isConfirmed();
}

}  // namespace

void Session::note(const SubmissionFault& fault, const std::string& function) {
  hasFailed_ = true;
  isOver_ = isOver_ || !concernsOneFunction(fault);
  if (fault_.empty() || isOver_) {
    fault_ = fault.what();
    outcome_ = fault.outcome();
    isConfirmed_ = fault.isConfirmed();
  }
  broken_.emplace(function, fault);
}

void Session::noteEndOfWorker(SubmissionFault fault, const std::string& function) {
  if (!worker_) {  // it did not load: no function will be asked
    isOver_ = true;
    return note(fault, function);
  }
  worker_->end();  // it may still be running
  needsFreshWorker_ = true;
  const bool isFirst = fault_.empty();
  const bool isEndless = fault.outcome() == Outcome::Cpu || std::string_view(fault.what()).ends_with(waitsSentence);
  if (isFirst && isEndless) timedOutFunction_ = function;
  if (fault.outcome() == Outcome::Cpu) fault = inItsTime(fault, function);
  cpuUsed_ += worker_->cpu() - cpuBefore_;
  note(fault, function);
}

/// What passed its limit in the words of the limit: that of one call, or that of all of them, after which none is made.
SubmissionFault Session::inItsTime(const SubmissionFault& fault, const std::string& function) {
  if (cpuUsed_ + setup_.limits.call <= setup_.limits.criterion) {
    return SubmissionFault(fmt::format("{} {}", function, limitSentence(setup_.limits.call)), fault.outcome());
  }
  isOver_ = true;
  const double seconds = static_cast<double>(setup_.limits.criterion.count()) / 1000.0;
  return SubmissionFault(
      fmt::format("the calls of this criterion took more than {} s of processor time together; the last was {}",
                  seconds, function),
      fault.outcome());
}

void Session::startWorker() {
  if (worker_ && !needsFreshWorker_) return;
  if (worker_) earlierOutput_ += worker_->output();
  worker_.reset();
  needsFreshWorker_ = false;
  try {
    worker_ = std::make_unique<WorkerProcess>(
        *setup_.sandbox, WorkerHost{setup_.host, setup_.sanitised, setup_.refilled}, setup_.submission, setup_.limits);
  } catch (const SubmissionFault& fault) {
    const bool endless = fault.outcome() == Outcome::Cpu || std::string_view(fault.what()).ends_with(waitsSentence);
    if (endless) timedOutFunction_ = loading;
    throw;
  }
}

std::vector<std::byte> Session::converse(const Request& request, const Patience& patience) {
  const std::uint64_t nonce = freshNonce();
  worker_->send(wire::FrameKind::Call, nonce, request.id, request.arguments, patience, request.function);
  for (;;) {
    wire::Frame frame = worker_->receive(nonce, patience, request.function);
    switch (frame.header.kind) {
      case wire::FrameKind::Result:
        return std::move(frame.payload);
      case wire::FrameKind::Callback:
        answerCallback(request, frame, nonce, patience);
        break;
      case wire::FrameKind::Thrown:
        throw SubmissionFault(fmt::format("{} {}", request.function, thrownSentence(wire::shortTextOf(frame))));
      case wire::FrameKind::Refused:
        throw refusal(frame, request.function);
      case wire::FrameKind::Died:
        throw deathFault(request.function, wire::shortTextOf(frame));
      default:
        throw SubmissionFault(request.function + " answered with a malformed message");
    }
  }
}

void Session::answerCallback(const Request& request, const wire::Frame& frame, std::uint64_t nonce,
                             const Patience& patience) {
  if (frame.header.target >= request.callbacks.size()) {
    throw SubmissionFault(request.function + " called a function that it was not given");
  }
  wire::FrameKind kind = wire::FrameKind::Answer;
  std::vector<std::byte> answer;
  try {
    answer = request.callbacks[frame.header.target](frame.payload);
  } catch (const wire::WireError& error) {
    throw SubmissionFault(
        fmt::format("{} called its argument with malformed values: {}", request.function, error.what()));
  } catch (const BadQuestion& question) {
    throw SubmissionFault(fmt::format("{} {}", request.function, question.what()));
  } catch (const ThrownToAsker& thrown) {
    kind = wire::FrameKind::AnswerThrew;
    const std::string_view words = thrown.what();
    const auto* bytes = reinterpret_cast<const std::byte*>(words.data());
    answer.assign(bytes, bytes + words.size());
  }
  worker_->send(kind, nonce, frame.header.target, answer, patience, request.function);
}

void Session::remember(const Request& request, const std::vector<std::byte>& reply) {
  if (request.arguments.size() + reply.size() > largestRemembered) return;
  if (past_.size() < rememberedCalls) {
    past_.push_back({request, reply});
  } else {
    past_[static_cast<std::size_t>(random_.integer(0, rememberedCalls - 1))] = {request, reply};
  }
}

/// A fault of another function than the one that was asked last is that function's: the test goes on.
void Session::repeatAnEarlierCall(const std::string& current) {
  const PastCall past = past_[static_cast<std::size_t>(random_.integer(0, static_cast<int>(past_.size()) - 1))];
  const std::string& function = past.request.function;
  if (broken_.contains(function)) return;
  const bool hadFailed = hasFailed_;
  try {
    if (answersAsBefore(past)) return;
    note(SubmissionFault(function +
                         " gave another answer when it was asked the same again: it must depend on its arguments alone "
                         "(no static variables, every variable initialised)"),
         function);
  } catch (const SubmissionFault&) {  // noted where it was thrown
  }
  unreliable_.insert(function);
  if (isOver_ || function == current) {
    describeLast_ = past.request.describe;
    throw SubmissionFault(broken_.contains(function) ? broken_.at(function) : SubmissionFault(fault_, outcome_));
  }
  hasFailed_ = hadFailed;
}

bool Session::answersAsBefore(const PastCall& past) { return exchange(past.request) == past.reply; }

}  // namespace muelle::grader
