/// \file
/// The worker during a call, looked at from outside: what the kernel says that it may do and see.

#include "fixture.h"
#include "fixture_session.h"
#include "process_status.h"
#include "support/eventually.h"

#include <fcntl.h>
#include <unistd.h>
#include <algorithm>

namespace {

using muelle::grader::familyOf;
using muelle::grader::hostOf;
using muelle::grader::ProcessStatus;
using muelle::grader::SandboxChoice;
using muelle::grader::Session;

constexpr const char* nothing = "0000000000000000";

/// Looks at the worker from a callback: the student's code is on its stack then.
class WorkerDuringACall : public muelle::grader::FixtureSession {
 protected:
  void look(const std::function<void(const ProcessStatus& host)>& at) {
    int looked = 0;
    submission::callTwice(
        [&](double x) {
          if (++looked == 1) at(hostOf(session().workerPid()));
          return x;
        },
        1.0);
    EXPECT_GE(looked, 2);
  }
};

TEST_F(WorkerDuringACall, HasNoCapabilityAndNeverGetsOne) {
  look([](const ProcessStatus& host) {
    for (const char* set : {"CapInh", "CapPrm", "CapEff", "CapAmb"}) EXPECT_EQ(host.field(set), nothing) << set;
    if (geteuid() == 0) {
      EXPECT_EQ(host.field("CapBnd"), nothing);
    }
    EXPECT_EQ(host.field("NoNewPrivs"), "1");
  });
}

TEST_F(WorkerDuringACall, RunsUnderItsFilters) {
  look([](const ProcessStatus& host) {
    EXPECT_EQ(host.field("Seccomp"), "2");
    EXPECT_GE(std::stoi(host.field("Seccomp_filters")), 2) << "one for loading, one for running";
    EXPECT_EQ(host.field("Threads"), "1");
  });
}

TEST_F(WorkerDuringACall, BelongsToNobodyWhenTheGraderIsRoot) {
  if (geteuid() != 0) GTEST_SKIP() << "only root can give its programs another user id";
  look([](const ProcessStatus& host) {
    const std::string user = host.field("Uid");
    const unsigned id = static_cast<unsigned>(std::stoul(user));
    EXPECT_GE(id, 2'000'000U) << user;
    EXPECT_EQ(host.field("Gid"), user);
    const std::string groups = host.field("Groups");
    EXPECT_TRUE(groups.empty() || groups == std::to_string(id)) << groups;
  });
}

TEST_F(WorkerDuringACall, LivesInNamespacesOfItsOwn) {
  if (sandbox().choice() != SandboxChoice::Bubblewrap) GTEST_SKIP() << "the weaker backends have none";
  look([](const ProcessStatus& host) {
    const ProcessStatus ours(getpid());
    for (const char* kind : {"net", "pid", "mnt", "ipc", "uts", "user"}) {
      EXPECT_FALSE(host.nameSpace(kind).empty()) << kind;
      EXPECT_NE(host.nameSpace(kind), ours.nameSpace(kind)) << kind;
    }
  });
}

TEST_F(WorkerDuringACall, HoldsFivePipesAndNothingThatWeHadOpen) {
  // Left open on purpose, without close-on-exec, as a careless caller of the grader might.
  const int secret = open("/etc/hostname", O_RDONLY);
  ASSERT_GE(secret, 0);
  const int low = dup2(secret, 7);
  start({});
  look([](const ProcessStatus& host) {
    const auto descriptors = host.descriptors();
    if (descriptors.empty() && geteuid() != 0) GTEST_SKIP() << "only root may look";
    ASSERT_EQ(descriptors.size(), 5U);
    EXPECT_EQ(descriptors.at(0), "/dev/null");
    for (const int number : {1, 2, 3, 4})
      EXPECT_TRUE(descriptors.at(number).starts_with("pipe:")) << descriptors.at(number);
  });
  close(low);
  close(secret);
}

TEST_F(WorkerDuringACall, HasNoTerminalAndNothingOfOurEnvironment) {
  setenv("MUELLE_SECRET_OF_THE_TEST", "4711", 1);
  start({});
  look([](const ProcessStatus& host) {
    EXPECT_EQ(host.terminal(), "0");
    EXPECT_EQ(host.environment().find("4711"), std::string::npos);
    EXPECT_EQ(host.environment().find("HOME="), std::string::npos);
    EXPECT_EQ(host.workingDirectory().find(MUELLE_HOST), std::string::npos);
    EXPECT_NE(host.workingDirectory(), ProcessStatus(getpid()).workingDirectory());
  });
  unsetenv("MUELLE_SECRET_OF_THE_TEST");
}

TEST_F(WorkerDuringACall, IsBoundedByLimits) {
  look([](const ProcessStatus& host) {
    EXPECT_EQ(host.limits("Max address space"), "1073741824 1073741824");
    EXPECT_EQ(host.limits("Max stack size"), "8388608 8388608");
    EXPECT_EQ(host.limits("Max core file size"), "0 0");
    EXPECT_EQ(host.limits("Max file size"), "0 0");
    EXPECT_EQ(host.limits("Max open files"), "16 16");
    EXPECT_EQ(host.limits("Max cpu time"), "15 20");
  });
}

TEST_F(WorkerDuringACall, LeavesNoProcessWhenTheSessionEnds) {
  submission::sum(1, 2, false);
  std::vector<pid_t> family;
  for (const ProcessStatus& process : familyOf(session().workerPid())) family.push_back(process.pid());
  EXPECT_FALSE(family.empty());
  start({});
  EXPECT_TRUE(muelle::eventually([&] {
    std::erase_if(family, [](pid_t pid) { return ProcessStatus(pid).field("State").empty(); });
    return family.empty();
  }));
}

/// The other half of the promise: the process that knows the expected values has none of the student's code.
TEST_F(WorkerDuringACall, OurProcessHasNotLoadedTheSubmission) {
  look([](const ProcessStatus& host) {
    const std::string submission = std::string(MUELLE_FIXTURE).substr(std::string(MUELLE_FIXTURE).rfind('/'));
    for (const std::string& file : ProcessStatus(getpid()).mappedFiles()) {
      EXPECT_EQ(file.find(submission), std::string::npos) << file;
      EXPECT_EQ(file.find("submission.so"), std::string::npos) << file;
    }
    const auto theirs = host.mappedFiles();
    EXPECT_TRUE(theirs.empty() || std::any_of(theirs.begin(), theirs.end(), [](const std::string& file) {
                  return file.find("submission.so") != std::string::npos;
                }));
  });
}

}  // namespace
