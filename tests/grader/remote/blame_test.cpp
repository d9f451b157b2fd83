/// \file
/// Whose doing it was: what the machine does to a worker from outside is never the submission's, and what a submission
/// does to itself never looks like the machine's.

#include "fixture.h"
#include "fixture_session.h"
#include "misbehaviour.h"
#include "process_status.h"

#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>

namespace {

using muelle::Outcome;
using muelle::grader::ProcessStatus;
using muelle::grader::Session;
using muelle::grader::SessionLimits;
using muelle::grader::SubmissionFault;
using muelle::grader::waitForEnd;
using std::chrono::milliseconds;
using namespace misbehaviour;

class Blame : public muelle::grader::FixtureSession {
 protected:
  /// Makes one call during which the worker gets a signal from outside.
  Outcome callWithSignal(int signal) {
    SessionLimits limits;
    limits.callWall = milliseconds(1000);
    start(limits);
    const auto call = [&] {
      submission::callTwice(
          [&](double x) {
            kill(session().hostPid(), signal);
            return x;
          },
          1.0);
    };
    EXPECT_THROW(call(), SubmissionFault);
    return session().outcome();
  }

  /// What loading another submission ends with.
  Outcome load(const char* submission) {
    Session other({&sandbox(), MUELLE_HOST, submission, 7, {}});
    Session::setCurrent(&other);
    EXPECT_THROW(submission::sum(1, 2, false), SubmissionFault);
    EXPECT_NE(other.fault().find("the code that runs when your file is loaded was stopped"), std::string::npos)
        << other.fault();
    Session::setCurrent(nullptr);
    return other.outcome();
  }
};

TEST_F(Blame, StoppedPastTheWallLimitIsTheMachines) {
  EXPECT_EQ(callWithSignal(SIGSTOP), Outcome::Wall) << session().fault();
  EXPECT_EQ(session().timedOutFunction(), "") << "no other criterion may be held against the function";
}

/// What a signal from outside makes of a call; `grade` tries each of these outcomes once more.
struct FromOutside {
  Outcome outcome;
  std::vector<int> signals;
};

/// Every signal that ends a process. Struck is the worker's word alone, which is believed the second time.
TEST_F(Blame, NoSignalFromOutsideIsTheSubmissions) {
  const std::vector<FromOutside> table{
      {Outcome::Killed,
       {SIGKILL, SIGTERM, SIGINT, SIGHUP, SIGQUIT, SIGUSR1, SIGUSR2, SIGALRM, SIGVTALRM, SIGPROF, SIGIO, SIGPWR,
        SIGSTKFLT, SIGRTMIN, SIGRTMAX}},
      {Outcome::Struck, {SIGSEGV, SIGBUS, SIGFPE, SIGSYS, SIGABRT, SIGILL, SIGTRAP, SIGPIPE, SIGXFSZ}},
      {Outcome::Cpu, {SIGXCPU}},
  };
  for (const auto& [outcome, signals] : table) {
    for (const int signal : signals) {
      EXPECT_EQ(callWithSignal(signal), outcome) << strsignal(signal) << ": " << session().fault();
    }
  }
}

TEST_F(Blame, NoSignalToTheSandboxIsTheSubmissions) {
  for (const int signal : {SIGKILL, SIGTERM, SIGSEGV, SIGBUS, SIGFPE, SIGSYS, SIGABRT, SIGILL, SIGTRAP, SIGPIPE,
                           SIGXFSZ, SIGXCPU, SIGINT, SIGRTMIN}) {
    start({});
    submission::sum(1, 2, false);
    kill(session().workerPid(), signal);
    waitForEnd(session().hostPid());
    EXPECT_THROW(submission::sum(1, 2, false), SubmissionFault);
    EXPECT_EQ(session().outcome(), Outcome::Killed) << strsignal(signal) << ": " << session().fault();
  }
}

TEST_F(Blame, StruckBetweenTwoCallsIsToldAtTheNext) {
  submission::sum(1, 2, false);
  kill(session().hostPid(), SIGSEGV);
  waitForEnd(session().hostPid());
  EXPECT_THROW(submission::sum(1, 2, false), SubmissionFault);
  EXPECT_EQ(session().outcome(), Outcome::Struck) << session().fault();
}

TEST_F(Blame, LoopThatNobodyWatchesEndsBySigxcpu) {
  submission::sum(1, 2, false);
  EXPECT_EQ(ProcessStatus(session().hostPid()).limits("Max cpu time"), "15 20") << "SIGKILL is not the first";
}

TEST_F(Blame, FilterThatVoidsOursIsRefused) { EXPECT_EQ(load(MUELLE_VOIDS), Outcome::Forbidden); }

TEST_F(Blame, NothingOutsideIsEmptiedAtLoad) {
  std::ofstream(MUELLE_CANARY) << "sings";
  std::filesystem::permissions(MUELLE_CANARY, std::filesystem::perms::all);
  EXPECT_EQ(load(MUELLE_TRUNCATES), Outcome::Forbidden);
  EXPECT_EQ(std::filesystem::file_size(MUELLE_CANARY), 5U);
  EXPECT_FALSE(std::filesystem::exists(MUELLE_CANARY ".new"));
}

TEST_F(Blame, NothingOutsideIsEmptiedWithoutASandboxEither) {
  std::ofstream(MUELLE_CANARY) << "sings";
  const auto unsafe = makeSandbox(muelle::grader::SandboxChoice::Unsafe);
  Session other({unsafe.get(), MUELLE_HOST, MUELLE_TRUNCATES, 7, {}});
  Session::setCurrent(&other);
  EXPECT_THROW(submission::sum(1, 2, false), SubmissionFault);
  EXPECT_EQ(std::filesystem::file_size(MUELLE_CANARY), 5U);
  EXPECT_FALSE(std::filesystem::exists(MUELLE_CANARY ".new"));
}

TEST_F(Blame, FreshMemoryHoldsTheSameSenselessNumbers) {
  EXPECT_LT(submission::misbehave(SumOfFreshMemory), -1e300) << "four times 0xfefe...";
  EXPECT_LT(submission::misbehave(SumOfGrownMemory), -1e300) << "realloc() fills nothing by itself";
}

}  // namespace
