#include "harness/check/run_child.h"

#include <gtest/gtest.h>
#include <chrono>
#include <csignal>
#include <functional>
#include <stdexcept>

namespace muelle {
namespace {

ChildResult shell(const std::string& script, double seconds = 10.0, std::size_t limit = 65536) {
  return runChild({{"sh", "-c", script}, {}, seconds, limit});
}

double secondsOf(const std::function<void()>& action) {
  const auto start = std::chrono::steady_clock::now();
  action();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

TEST(RunChild, TellsOutputReportAndExitCode) {
  const ChildResult result = shell("echo out; echo err >&2; echo report >&3; exit 3");
  EXPECT_EQ(result.output, "out\nerr\n");
  EXPECT_EQ(result.report, "report\n");
  EXPECT_EQ(result.exitCode, 3);
  EXPECT_EQ(result.signal, 0);
}

TEST(RunChild, TellsTheSignal) { EXPECT_EQ(shell("kill -SEGV $$").signal, SIGSEGV); }

TEST(RunChild, EndsWhatDoesNotEnd) {
  ChildResult result;
  const double seconds = secondsOf([&] { result = shell("trap '' TERM INT; while :; do sleep 0.05; done", 0.3); });
  EXPECT_TRUE(result.timedOut);
  EXPECT_LT(seconds, 5.0);
}

TEST(RunChild, DoesNotWaitForWhatTheChildLeavesBehind) {
  EXPECT_LT(secondsOf([] { EXPECT_EQ(shell("sleep 30 & echo done").output, "done\n"); }), 5.0);
}

TEST(RunChild, ReadsEndlessOutputAndKeepsItsBeginning) {
  const ChildResult result = shell("yes", 0.3, 1000);
  EXPECT_EQ(result.output.size(), 1000U);
  EXPECT_TRUE(result.timedOut);
}

TEST(RunChild, GivesNoInput) { EXPECT_EQ(shell("cat; echo end").output, "end\n"); }

TEST(RunChild, AProgramThatIsNotThereIsAnError) {
  EXPECT_THROW(runChild({{"no-such-program-here"}, {}, 5.0, 1000}), std::runtime_error);
}

}  // namespace
}  // namespace muelle
