#include "course/check/fault_sentences.h"

#include <gtest/gtest.h>
#include <csignal>

namespace muelle {
namespace {

TEST(FaultSentences, SayWhatASignalMeans) {
  for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGTRAP, SIGABRT}) {
    EXPECT_NE(signalSentence(signal), nullptr) << signal;
  }
  EXPECT_STREQ(signalSentence(SIGFPE), "divided an integer by zero");
  EXPECT_EQ(signalSentence(SIGKILL), nullptr) << "it comes from outside";
}

TEST(FaultSentences, SayHowLongACallMayTake) {
  EXPECT_EQ(limitSentence(std::chrono::milliseconds(2000)), "did not return within 2 s of processor time");
  EXPECT_EQ(limitSentence(std::chrono::milliseconds(300)), "did not return within 0.3 s of processor time");
}

TEST(FaultSentences, TellTheCodeOfAnExitAsTheParentSeesIt) {
  EXPECT_EQ(exitSentence(0), "ended the program with exit(0) instead of returning");
  EXPECT_EQ(exitSentence(-1), "ended the program with exit(255) instead of returning");
}

TEST(FaultSentences, TellAnExceptionThatNobodyCaughtInOneLine) {
  EXPECT_EQ(uncaughtSentence("a\nb").find('\n'), std::string::npos);
  EXPECT_LT(uncaughtSentence(std::string(9000, 'x')).size(), 1000U);
  EXPECT_EQ(uncaughtSentence(""), "threw an exception that nobody caught, and that has no text");
}

}  // namespace
}  // namespace muelle
