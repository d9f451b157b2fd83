#include "course/check/crash_report.h"

#include "base/process/signal_origin.h"
#include "course/check/compile_rules.h"
#include "course/check/fault_sentences.h"
#include "course/check/thrown_sentence.h"
#include "course/testing/call_record.h"
#include "course/time_limits.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <unistd.h>
#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <exception>

namespace muelle {

namespace {

constexpr int reportDescriptor = 3;
constexpr long tickMilliseconds = 100;
constexpr long inSecond = 1000;  // [ms]

constexpr int asleepLimitSeconds = 10;
constexpr double nothingSeconds = 0.001;  // of processor time in a second: what a look itself takes

int report = STDERR_FILENO;
long slowness = 1;                   // times the limits of processor time
int callSeconds = usualCallSeconds;  // of processor time: a busy machine costs nobody anything
bool isLoading = true;               // until main() begins
char alternateStack[65536];
std::uintptr_t stackTop = 0;
std::uintptr_t stackLimit = 0;

/// Collects a line without allocating: a signal handler calls it.
class Line {
 public:
  Line& operator<<(const char* text) {
    for (; *text != '\0' && used_ < sizeof text_ - 1; ++text) text_[used_++] = *text == '\n' ? ' ' : *text;
    return *this;
  }
  void send() {
    text_[used_++] = '\n';
    writeReport({text_, used_});
  }

 private:
  char text_[1024];
  std::size_t used_ = 0;
};

const char* runningFunction() {
  if (CallRecord::current() != nullptr) return CallRecord::current()->function();
  return isLoading ? loadingCode : "the program";
}

/// Whether the code that runs is a student's.
bool isStudents() { return isLoading || CallRecord::current() != nullptr; }

/// Writes the report of a crash and ends the process.
[[noreturn]] void sendAndEnd(const char* subject, const char* sentence, const char* outcome = "crash") {
  Line outcomeLine;
  outcomeLine << "outcome\t" << outcome;
  outcomeLine.send();
  Line line;
  line << "crash\t" << subject << sentence;
  line.send();
  // The call that did it; setLastCall() was complete before the call began.
  if (CallRecord::current() != nullptr && CallRecord::printsArguments()) {
    Line call;
    call << "call\t" << CallRecord::lastCall().c_str();
    call.send();
  }
  _exit(1);
}

/// A sentence about the student's function that runs.
[[noreturn]] void sayAndEnd(const char* sentence, const char* outcome = "crash") {
  static char subject[200];
  std::strncat(subject, runningFunction(), sizeof subject - 2);
  std::strncat(subject, " ", 2);
  sendAndEnd(subject, sentence, outcome);
}

void onSignal(int signal, siginfo_t* info, void*) {
  if (wasSentByAnother(*info)) sayAndEnd(struckSentence, "struck");
  const bool isSegment = signal == SIGSEGV || signal == SIGBUS;
  if (isSegment && isStackOverflow(info->si_addr, stackTop, stackLimit)) sayAndEnd(stackOverflowSentence);
  if (signal == SIGFPE && info->si_code != FPE_INTDIV) sayAndEnd(trapSentence);
  sayAndEnd(signalSentence(signal));
}

/// Written before a signal handler asks for it.
const char* callLimitSentence() {
  static const std::string sentence = limitSentence(std::chrono::seconds(callSeconds));
  return sentence.c_str();
}

const char* totalLimitSentence() {
  static const std::string sentence =
      fmt::format("all calls together took more than {} s of processor time", allCallsSeconds(callSeconds));
  return sentence.c_str();
}

/// Counts how much processor time the innermost call has taken, and all calls.
void onTick(int) {
  static long seenCount = -1;
  static long lasted = 0;
  static long total = 0;
  total += tickMilliseconds;
  const bool sameCall = isStudents() && CallRecord::count() == seenCount;
  lasted = sameCall ? lasted + tickMilliseconds : 0;
  seenCount = CallRecord::count();
  if (lasted >= slowness * callSeconds * inSecond) sayAndEnd(callLimitSentence(), "processor time");
  if (total >= slowness * allCallsSeconds(callSeconds) * inSecond) {
    sendAndEnd("", totalLimitSentence(), "processor time");
  }
}

/// Processor time of this thread alone: AddressSanitizer has one more that wakes up all the time. Signals go to the
/// first thread, and a student's file starts no other.
double threadSeconds() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// Every second of wall time: a call that is looked at again and again, and has done nothing in between, sleeps for
/// ever. On a busy machine, or stopped, the process is not looked at either.
void onLook(int) {
  static long seenCount = -1;
  static double seenClock = 0;
  static int asleep = 0;
  const double now = threadSeconds();
  const bool sameCall = isStudents() && CallRecord::count() == seenCount;
  asleep = sameCall && now - seenClock < nothingSeconds ? asleep + 1 : 0;
  seenCount = CallRecord::count();
  seenClock = now;
  if (asleep >= asleepLimitSeconds) sayAndEnd(waitsSentence);
}

void onTerminate() {
  const std::exception_ptr exception = std::current_exception();
  if (!exception) sayAndEnd(abortSentence);
  try {
    std::rethrow_exception(exception);
  } catch (const EigenMisuse& error) {
    sendAndEnd("", error.what());
  } catch (const std::exception& error) {
    sayAndEnd(uncaughtSentence(textOf(error)).c_str());
  } catch (...) {
    sayAndEnd(uncaughtSentence("").c_str());
  }
}

#ifdef __GLIBC__
void onExit(int code, void*) {
  if (isStudents()) sayAndEnd(exitSentence(code).c_str());
}
void watchForExit() { on_exit(onExit, nullptr); }
#else
/// Other libraries do not tell the code; exit(0) is the one that is written.
void onExit() {
  if (isStudents()) sayAndEnd(exitSentence(0).c_str());
}
void watchForExit() { std::atexit(onExit); }
#endif

void handle(int signal, void (*handler)(int, siginfo_t*, void*)) {
  struct sigaction action {};
  action.sa_sigaction = handler;
  action.sa_flags = SA_SIGINFO | SA_ONSTACK;
  sigaction(signal, &action, nullptr);
}

void startTimer(int which, int signal, void (*handler)(int), const timeval& interval) {
  struct sigaction action {};
  action.sa_handler = handler;
  action.sa_flags = SA_ONSTACK | SA_RESTART;
  sigaction(signal, &action, nullptr);
  const itimerval timer{interval, interval};
  setitimer(which, &timer, nullptr);
}

void startClocks() {
  startTimer(ITIMER_PROF, SIGPROF, onTick, {0, tickMilliseconds * 1000});
  startTimer(ITIMER_REAL, SIGALRM, onLook, {1, 0});
}

}  // namespace

void endWithCrash(const char* sentence) { sayAndEnd(sentence); }

void writeReport(std::string_view text) {
  while (!text.empty()) {
    const ssize_t count = write(report, text.data(), text.size());
    if (count < 0 && errno != EINTR) return;
    if (count > 0) text.remove_prefix(static_cast<std::size_t>(count));
  }
}

namespace {

void findReport() {
  if (fcntl(reportDescriptor, F_GETFD) < 0) return;
  report = reportDescriptor;
  // gnuplot, which a demo starts, must not hold the report open.
  fcntl(reportDescriptor, F_SETFD, FD_CLOEXEC);
}

void measureStack() {
  rlimit limit{};
  constexpr std::uintptr_t usual = 8U << 20U;
  const bool known = getrlimit(RLIMIT_STACK, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY;
  stackLimit = known ? static_cast<std::uintptr_t>(limit.rlim_cur) : usual;
  stackTop = reinterpret_cast<std::uintptr_t>(__builtin_frame_address(0));
}

void installHandlers() {
  stack_t stack{};
  stack.ss_sp = alternateStack;
  stack.ss_size = sizeof alternateStack;
  sigaltstack(&stack, nullptr);
  for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGTRAP, SIGABRT}) handle(signal, onSignal);
  std::set_terminate(onTerminate);
  // The call records exist before a handler asks for them, and longer than it may ask.
  CallRecord::setLastCall("");
  CallRecord::count() = 0;
  CallRecord::current() = nullptr;
  CallRecord::printsArguments() = true;
  callLimitSentence();
  totalLimitSentence();
  watchForExit();
  startClocks();
}

/// "program tests slowly"
long slownessOf(int argc, char** argv) {
  return argc > 2 && std::string_view(argv[2]) == "slowly" ? long{sanitizedFactor} : 1;
}

/// Of a program that somebody starts by hand: the usual ones.
int callSecondsOfEnvironment() {
  const char* text = std::getenv(callSecondsVariable);
  const long seconds = text != nullptr ? std::strtol(text, nullptr, 10) : 0;
  const bool isSane = seconds >= usualCallSeconds && seconds <= longestCallSeconds;
  return isSane ? static_cast<int>(seconds) : usualCallSeconds;
}

/// Before the initialisers of the student's file, which run before main(); with main()'s arguments.
__attribute__((constructor(101))) void watchLoading(int argc, char** argv) {
  slowness = slownessOf(argc, argv);
  callSeconds = callSecondsOfEnvironment();
  findReport();
  measureStack();
  installHandlers();
}

}  // namespace

void watchForCrashes() {
  isLoading = false;
  // Once more: the student's initialisers may have put it off.
  measureStack();
  installHandlers();
}

}  // namespace muelle
