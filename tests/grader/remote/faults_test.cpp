/// \file
/// What the test process says and does when the worker does anything else than answer.

#include "fixture.h"
#include "fixture_session.h"
#include "misbehaviour.h"
#include "process_status.h"

#include <sys/resource.h>
#include <unistd.h>

#include <chrono>
#include <regex>

namespace {

using muelle::Outcome;
using muelle::grader::Session;
using muelle::grader::SessionLimits;
using muelle::grader::SubmissionFault;
using muelle::grader::waitForEnd;
using std::chrono::milliseconds;

struct Fault {
  misbehaviour::How how;
  const char* says;
  Outcome outcome = Outcome::Wrong;
};

/// What GoogleTest, and CTest after it, call a case: without this, its bytes.
void PrintTo(const Fault& fault, std::ostream* out) { *out << fault.says; }

class Misbehaviour : public muelle::grader::FixtureSession, public ::testing::WithParamInterface<Fault> {};

TEST_P(Misbehaviour, IsNamedAndEndsTheCallsOfItsFunction) {
  SessionLimits limits;
  limits.call = milliseconds(300);
  limits.callWall = milliseconds(4000);
  start(limits);
  EXPECT_EQ(submission::sum(1, 2, false), 3);
  const auto begin = std::chrono::steady_clock::now();
  std::string words;
  try {
    submission::misbehave(GetParam().how);
    submission::misbehave(GetParam().how);  // a forged answer is found out at the next call
    submission::sum(1, 2, false);
  } catch (const SubmissionFault& fault) {
    words = fault.what();
  }
  EXPECT_TRUE(std::regex_search(words, std::regex(GetParam().says))) << words;
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(20));
  EXPECT_EQ(session().graderFault(), "");
  EXPECT_EQ(session().fault(), words);
  EXPECT_EQ(session().outcome(), GetParam().outcome) << nameOf(session().outcome());
  EXPECT_THROW(submission::misbehave(GetParam().how), SubmissionFault) << "it is not believed afterwards";
  if (GetParam().outcome == Outcome::Forbidden) {
    EXPECT_THROW(submission::sum(1, 2, false), SubmissionFault) << "nothing is believed afterwards";
  } else {
    EXPECT_EQ(submission::sum(1, 2, false), 3) << "the other functions are asked in a fresh worker";
  }
  EXPECT_EQ(session().fault(), words);
}

using namespace misbehaviour;
INSTANTIATE_TEST_SUITE_P(
    Each, Misbehaviour,
    ::testing::Values(
        Fault{Throw, "misbehave threw an exception: the spring is broken"},
        Fault{ThrowNumber, "misbehave threw something without a text: no std::exception"},
        Fault{IndexOutOfRange, "index 3 of a 3-vector in misbehave", Outcome::Crash},
        Fault{StackOverflow, "misbehave ran out of stack", Outcome::Crash},
        Fault{NullPointer, "misbehave used memory that is not its own", Outcome::Crash},
        Fault{DivideByZero, "misbehave divided an integer by zero", Outcome::Crash},
        Fault{Exit, R"(misbehave ended the program with exit\(0\))", Outcome::Crash},
        Fault{Abort, R"(misbehave called abort\(\))", Outcome::Crash},
        Fault{BreakPromise, "misbehave threw an exception that nobody caught: beyond the last spring", Outcome::Crash},
        Fault{BreakHeap, R"(misbehave damaged the heap: .*\((free|double free|malloc|munmap).*\))", Outcome::Crash},
        Fault{Loop, "misbehave did not return within 0.3 s of processor time", Outcome::Cpu},
        Fault{StopItself, "misbehave was stopped", Outcome::Forbidden},
        Fault{KillItself, "misbehave was stopped", Outcome::Forbidden},
        Fault{ExitAsIfKilled, "misbehave was stopped", Outcome::Forbidden},
        Fault{LockTwice, "misbehave waits without end", Outcome::Crash},
        Fault{ReadThePipe, "misbehave waits without end", Outcome::Crash},
        Fault{PutSignalsOff, "misbehave did not return within 0.3 s of processor time", Outcome::Cpu},
        Fault{VectorIndex, "misbehave used an index beyond the end of a std::vector", Outcome::Crash},
        Fault{InstallFilter, "'seccomp'", Outcome::Forbidden}, Fault{HugeFrame, "a message of 4294967295 bytes"},
        Fault{WrongNonce, "misbehave answered a question that was not asked"},
        Fault{UnknownCallback, "called a function that it was not given"},
        Fault{ShortAnswer, "returned something else than its type"},
        Fault{DieBetweenCalls, R"(ended the program with exit\(0\))", Outcome::Crash},
        Fault{Fork, "'(clone|fork)'", Outcome::Forbidden}, Fault{Socket, "'socket'", Outcome::Forbidden},
        Fault{Open, "'openat'", Outcome::Forbidden}, Fault{Sleep, "'(clock_)?nanosleep'", Outcome::Forbidden}),
    [](const auto& fault) { return "How" + std::to_string(fault.param.how); });

using Faults = muelle::grader::FixtureSession;

TEST_F(Faults, ChangedAnswersAreFoundOut) {
  const auto manyCalls = [] {
    for (int i = 0; i < 200; ++i) submission::misbehave(CountCalls);
  };
  EXPECT_THROW(manyCalls(), SubmissionFault);
  EXPECT_NE(session().fault().find("gave another answer when it was asked the same again"), std::string::npos);
}

TEST_F(Faults, AChangedAnswerOfAnotherFunctionIsThatFunctionsAlone) {
  for (int i = 0; i < 5; ++i) submission::misbehave(CountCalls);  // too few to be asked again, as the seed has it
  for (int i = 0; i < 200; ++i) EXPECT_EQ(submission::sum(i, 2, false), i + 2);
  EXPECT_NE(session().fault().find("misbehave gave another answer"), std::string::npos) << session().fault();
  EXPECT_TRUE(session().unreliable().contains("misbehave")) << "a test that has believed it is withdrawn";
  EXPECT_THROW(submission::misbehave(CountCalls), SubmissionFault);
}

TEST_F(Faults, OutputIsDrainedAndCut) {
  EXPECT_EQ(submission::misbehave(Flood), 1) << "8 MB of output harm nobody";
  EXPECT_LT(session().output().size(), 66'000U);
  EXPECT_NE(session().output().find("was cut"), std::string::npos);
}

TEST_F(Faults, MalformedCallbackIsTheStudents) {
  const auto call = [] { submission::callTwice([](double x) { return x; }, malformedCallback); };
  EXPECT_THROW(call(), SubmissionFault);
  EXPECT_NE(session().fault().find("called its argument with malformed values"), std::string::npos)
      << session().fault();
}

TEST_F(Faults, AQuestionWithoutAnswerIsTheStudents) {
  const auto call = [] {
    submission::callTwice([](double) -> double { throw muelle::BadQuestion("asks for the root of a negative number"); },
                          2);
  };
  EXPECT_THROW(call(), SubmissionFault);
  EXPECT_EQ(session().fault(), "callTwice asks for the root of a negative number");
}

TEST_F(Faults, CallsThatAreSlowTogetherRunOutOfTheCriterionsTime) {
  SessionLimits limits;
  limits.call = milliseconds(5000);
  limits.criterion = milliseconds(150);
  start(limits);
  int calls = 0;
  const auto many = [&calls] {
    for (int i = 0; i < 100'000; ++i, ++calls) submission::wrongSize(100'000 + i);
  };
  EXPECT_THROW(many(), SubmissionFault);
  EXPECT_NE(session().fault().find("took more than 0.15 s of processor time together"), std::string::npos)
      << session().fault();
  EXPECT_EQ(session().outcome(), Outcome::Cpu);
  EXPECT_EQ(session().timedOutFunction(), "wrongSize");
  EXPECT_GT(calls, 1);
}

TEST(Limits, OfAnExerciseWhoseCallsTakeLonger) {
  const SessionLimits usual, longer = usual.forCallsOf(15);
  EXPECT_EQ(usual.forCallsOf(2).call, usual.call);
  EXPECT_EQ(usual.forCallsOf(2).criterion, usual.criterion);
  EXPECT_EQ(usual.forCallsOf(2).callWall, usual.callWall);
  EXPECT_EQ(longer.call, milliseconds(15'000));
  EXPECT_EQ(longer.criterion, milliseconds(23'000)) << "as in check";
  EXPECT_GT(longer.callWall, 4 * longer.call) << "a busy machine costs nobody anything";
}

TEST_F(Faults, LastCallIsShownWithItsInput) {
  EXPECT_THROW(submission::misbehave(NullPointer), SubmissionFault);
  EXPECT_EQ(session().lastCall(), "misbehave(" + std::to_string(NullPointer) + ")");
}

TEST_F(Faults, DyingBetweenTwoCallsDoesNotTakeTheTestProcessWithIt) {
  EXPECT_EQ(submission::misbehave(DieBetweenCalls), 1) << "the forged answer came before the end";
  waitForEnd(session().hostPid());  // until nobody reads the pipe
  EXPECT_THROW(submission::sum(1, 2, false), SubmissionFault);
}

TEST_F(Faults, HugeAnswersAreNotHoarded) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "the sanitizer keeps freed memory back, so that this process looks larger than it is";
#endif
  constexpr int count = 1'000'000;  // 8 MB
  for (int i = 0; i < 40; ++i) ASSERT_EQ(submission::wrongSize(count + i).size(), count + i);
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  EXPECT_LT(usage.ru_maxrss, 200 * 1024) << "[kB]";
}

TEST_F(Faults, MissingWorkerIsTheGradersFault) {
  const auto sandbox = muelle::grader::makeSandbox(muelle::grader::SandboxChoice::Automatic);
  Session broken({sandbox.get(), MUELLE_HOST, "/nowhere/submission.so", 1, {}});
  Session::setCurrent(&broken);
  EXPECT_THROW(submission::sum(1, 2, false), muelle::grader::GraderFault);
  EXPECT_NE(broken.graderFault(), "");
  EXPECT_EQ(broken.fault(), "");
}

}  // namespace
