#include "base/process/child.h"

#include <gtest/gtest.h>
#include <chrono>
#include <csignal>
#include <functional>
#include <stdexcept>

namespace muelle {
namespace {

CommandResult shell(const std::string& script, std::chrono::milliseconds limit = std::chrono::seconds(10),
                    std::size_t bytes = 65536) {
  ChildSpec spec;
  spec.command = {"sh", "-c", script};
  spec.inheritsEnvironment = true;
  return runCommand(spec, {limit, bytes, bytes, bytes, true});
}

double secondsOf(const std::function<void()>& action) {
  const auto start = std::chrono::steady_clock::now();
  action();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

TEST(Child, TellsOutputReportAndExitCode) {
  const CommandResult result = shell("echo out; echo err >&2; echo report >&3; exit 3");
  EXPECT_EQ(result.out, "out\nerr\n");
  EXPECT_EQ(result.report, "report\n");
  EXPECT_EQ(result.status.code, 3);
  EXPECT_FALSE(result.status.signalled);
}

TEST(Child, TellsTheSignal) {
  const ExitStatus status = shell("kill -SEGV $$").status;
  EXPECT_TRUE(status.signalled);
  EXPECT_EQ(status.code, SIGSEGV);
}

TEST(Child, EndsWhatDoesNotEnd) {
  CommandResult result;
  const double seconds = secondsOf(
      [&] { result = shell("trap '' TERM INT; while :; do sleep 0.05; done", std::chrono::milliseconds(300)); });
  EXPECT_TRUE(result.timedOut);
  EXPECT_LT(seconds, 5.0);
}

TEST(Child, DoesNotWaitForWhatTheChildLeavesBehind) {
  EXPECT_LT(secondsOf([] { EXPECT_EQ(shell("sleep 30 & echo done").out, "done\n"); }), 5.0);
}

TEST(Child, ReadsEndlessOutputAndKeepsItsBeginning) {
  const CommandResult result = shell("yes", std::chrono::milliseconds(300), 1000);
  EXPECT_EQ(result.out.size(), 1000U);
  EXPECT_TRUE(result.timedOut);
}

TEST(Child, GivesNoInput) { EXPECT_EQ(shell("cat; echo end").out, "end\n"); }

TEST(Child, AProgramThatIsNotThereIsAnError) {
  ChildSpec spec;
  spec.command = {"no-such-program-here"};
  EXPECT_THROW(runCommand(spec, {}), std::runtime_error);
}

TEST(Child, CountsTheProcessorTimeOfItsChildren) {
  const double seconds = shell("sh -c 'i=0; while [ $i -lt 200000 ]; do i=$((i+1)); done'").status.cpuSeconds;
  EXPECT_GT(seconds, 0.02);
  EXPECT_LT(seconds, 10.0);
}

TEST(Child, EndsWithSigxcpuAtItsLimitOfProcessorTime) {
  ChildSpec spec;
  spec.command = {"sh", "-c", "while :; do :; done"};
  spec.limits.cpuSeconds = 1;
  const CommandResult result = runCommand(spec, {std::chrono::seconds(30)});
  EXPECT_TRUE(result.status.signalled);
  EXPECT_EQ(result.status.code, SIGXCPU);
}

TEST(Child, InheritsTheEnvironmentOnlyWhenAsked) {
  setenv("MUELLE_TEST_VARIABLE", "ours", 1);
  ChildSpec spec;
  spec.command = {"/bin/sh", "-c", "echo \"$MUELLE_TEST_VARIABLE\""};
  EXPECT_EQ(runCommand(spec, {}).out, "\n");
  spec.inheritsEnvironment = true;
  EXPECT_EQ(runCommand(spec, {}).out, "ours\n");
  spec.environment = {"MUELLE_TEST_VARIABLE=given"};
  EXPECT_EQ(runCommand(spec, {}).out, "given\n");
}

}  // namespace
}  // namespace muelle
