/// \file
/// The host with AddressSanitizer: it says what it found in words for a student, and is bounded from outside.

#include "fixture.h"
#include "fixture_session.h"
#include "misbehaviour.h"

#include <regex>

namespace {

using muelle::Outcome;
using muelle::grader::Session;
using muelle::grader::SubmissionFault;
using namespace misbehaviour;

class SanitisedWorker : public muelle::grader::FixtureSession {
 protected:
  void begin(muelle::grader::SessionLimits limits) {
    session_ =
        std::make_unique<Session>(Session::Setup{&sandbox(), MUELLE_HOST_ASAN, MUELLE_FIXTURE_ASAN, 7, limits, true});
    Session::setCurrent(session_.get());
  }
  void SetUp() override { begin({}); }

  void expect(How how, const char* says, bool isConfirmed = true) {
    EXPECT_THROW(submission::misbehave(how), SubmissionFault);
    EXPECT_TRUE(std::regex_search(session_->fault(), std::regex(says))) << session_->fault() << session_->output();
    EXPECT_EQ(session_->outcome(), Outcome::Crash);
    EXPECT_EQ(session_->isConfirmed(), isConfirmed);
  }

  std::unique_ptr<Session> session_;
};

TEST_F(SanitisedWorker, ComputesAsTheOther) {
  EXPECT_EQ(submission::sum(1, 2, false), 3);
  EXPECT_EQ(submission::reversed(VecX::LinSpaced(4, 0, 3)), VecX(VecX::LinSpaced(4, 3, 0)));
  EXPECT_EQ(session_->output(), "");
}

TEST_F(SanitisedWorker, NamesAReferenceToAValueThatIsGone) {
  expect(KeepsReference, "misbehave uses .*variable.*(that is gone|of a function that has returned)");
}

TEST_F(SanitisedWorker, NamesALocalArrayThatIsOverrun) {
  expect(BeyondLocalArray, "misbehave reads or writes beyond the end of a local array");
}

TEST_F(SanitisedWorker, NamesMemoryThatIsOverrun) {
  expect(BeyondHeap, "misbehave reads or writes beyond the end of a std::vector");
}

TEST_F(SanitisedWorker, NamesAMissingReturn) {
  expect(NoReturn, "misbehave ends without returning a value at fixture.cpp:[0-9]+");
}

/// Only what a sanitizer reports is confirmed: stack, memory and time are dearer here.
TEST_F(SanitisedWorker, OtherCrashesConfirmNothing) {
  expect(NullPointer, "misbehave used memory that is not its own", false);
}

TEST_F(SanitisedWorker, AStackThatRunsOutConfirmsNothing) {
  expect(StackOverflow, "misbehave ran out of stack", false);
}

TEST_F(SanitisedWorker, IsBoundedInMemory) {
  muelle::grader::SessionLimits limits;
  limits.sanitisedMemory = 256UL << 20;
  begin(limits);
  expect(UseMemory, "misbehave used more than 256 MiB of memory", false);
}

}  // namespace
