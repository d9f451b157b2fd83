#include "base/file.h"
#include "grader/sandbox/landlock.h"
#include "grader/sandbox/sandbox.h"
#include "grader/sandbox/unsafe.h"
#include "support/eventually.h"

#include <gtest/gtest.h>

#include <unistd.h>

#include <filesystem>
#include <fstream>

namespace muelle::grader {
namespace {

namespace fs = std::filesystem;

TEST(SandboxChoiceText, GoesThereAndBack) {
  for (const char* text : {"auto", "bubblewrap", "landlock", "unsafe"})
    EXPECT_EQ(toText(parseSandboxChoice(text)), text);
  EXPECT_EQ(parseSandboxChoice(""), SandboxChoice::Automatic);
  EXPECT_THROW(parseSandboxChoice("none"), std::runtime_error);
}

TEST(SandboxDescription, SaysWhatIsWeaker) {
  EXPECT_NE(makeSandbox(SandboxChoice::Unsafe)->description().find("UNSAFE"), std::string::npos);
  const std::string text = Landlock("bubblewrap is not installed").description();
  EXPECT_NE(text.find("weaker"), std::string::npos);
  EXPECT_NE(text.find("bubblewrap is not installed"), std::string::npos);
}

/// Whether a process has the word in its command line.
bool isRunning(const std::string& word) {
  for (const auto& entry : fs::directory_iterator("/proc")) {
    std::ifstream stream(entry.path() / "cmdline");
    std::string line;
    std::getline(stream, line);
    if (line.find(word) != std::string::npos) return true;
  }
  return false;
}

/// Runs a shell script in each backend that this machine has.
class Backend : public ::testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    try {
      sandbox_ = makeSandbox(parseSandboxChoice(GetParam()));
    } catch (const std::runtime_error& error) {
      GTEST_SKIP() << error.what();
    }
  }

  CommandResult shell(const std::string& script, std::chrono::milliseconds limit = std::chrono::seconds(10)) const {
    Confinement confinement;
    confinement.command = {"/usr/bin/sh", "-c", script};
    confinement.systemFolders = {"/usr/bin", "/usr/lib"};
    if (fs::exists("/usr/lib64")) confinement.systemFolders.emplace_back("/usr/lib64");
    confinement.files = {{"/given/text", {}, "what was handed over\n", false}};
    confinement.scratchBytes = 1 << 20;
    return sandbox_->run(confinement, {limit, 65536, 65536, 0, false});
  }
  bool isUnsafe() const { return sandbox_->choice() == SandboxChoice::Unsafe; }

  std::unique_ptr<Sandbox> sandbox_;
};

TEST_P(Backend, ShowsWhatIsHandedOverAndLetsScratchBeWritten) {
  const CommandResult result = shell("cat given/text && echo scratch > tmp/file && cat tmp/file");
  EXPECT_EQ(result.out, "what was handed over\nscratch\n") << result.err;
  EXPECT_EQ(result.status.code, 0);
}

TEST_P(Backend, OpensNothingElse) {
  if (isUnsafe()) GTEST_SKIP() << "the unsafe backend opens everything";
  for (const char* file :
       {"/etc/passwd", "/etc/shadow", "/proc/self/maps", "/proc/1/environ", "/dev/zero", "/dev/tty"}) {
    const CommandResult result = shell(std::string("cat ") + file + " | head -c 100");
    EXPECT_EQ(result.out, "") << file;
    EXPECT_NE(result.err, "") << file;
  }
}

TEST_P(Backend, WritesNothingElse) {
  if (isUnsafe()) GTEST_SKIP() << "the unsafe backend writes everywhere";
  const std::string name = "muelle-dropped-" + std::to_string(getpid());
  for (const std::string folder : {"/tmp/../", "/var/tmp/", "/dev/shm/", "./", "given/"}) {
    EXPECT_NE(shell("echo dropped > " + folder + name).status.code, 0) << folder;
  }
  for (const char* folder : {"/", "/tmp", "/var/tmp", "/dev/shm"}) EXPECT_FALSE(fs::exists(fs::path(folder) / name));
  EXPECT_NE(shell("echo more >> given/text").status.code, 0);
}

TEST_P(Backend, EndsWhatRunsTooLongWithEverythingItHasStarted) {
  const auto start = std::chrono::steady_clock::now();
  const std::string mark = "7." + std::to_string(getpid());  // found again among all processes
  const CommandResult result = shell("sleep 36" + mark + " & sleep 36" + mark, std::chrono::milliseconds(500));
  EXPECT_TRUE(result.timedOut);
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(5));
  EXPECT_TRUE(eventually([&] { return !isRunning("36" + mark); }));
}

TEST_P(Backend, DrainsAndCutsOutput) {
  const CommandResult result = shell("head -c 300000 /usr/bin/sh; head -c 300000 /usr/lib/os-release /usr/bin/sh >&2");
  EXPECT_LE(result.out.size(), 65536U);
  EXPECT_LE(result.err.size(), 65536U);
  EXPECT_TRUE(result.outCut);
  EXPECT_FALSE(result.timedOut);
}

TEST_P(Backend, LeavesNoFolderBehind) {
  // A temporary folder of its own: in the common one other tests come and go.
  const TemporaryFolder own(::testing::TempDir());
  setenv("TMPDIR", own.path().c_str(), 1);
  ASSERT_EQ(fs::temp_directory_path(), own.path());
  shell("true");
  EXPECT_TRUE(fs::is_empty(own.path()));
  unsetenv("TMPDIR");
}

INSTANTIATE_TEST_SUITE_P(Each, Backend, ::testing::Values("bubblewrap", "landlock", "unsafe"),
                         [](const auto& backend) { return std::string(backend.param); });

TEST(LandlockBackend, DeniesTheNetworkAndOtherProcesses) {
  const std::string reason = Landlock::whyNot();
  if (!reason.empty()) GTEST_SKIP() << reason;
  Confinement confinement;
  confinement.systemFolders = {"/usr/bin", "/usr/lib"};
  confinement.command = {"/usr/bin/bash", "-c", "echo > /dev/tcp/127.0.0.1/9; kill -0 " + std::to_string(getpid())};
  const CommandResult result = Landlock().run(confinement, {std::chrono::seconds(5), 1000, 5000, 0, false});
  EXPECT_NE(result.status.code, 0);
  EXPECT_NE(result.err.find("Operation not permitted"), std::string::npos) << result.err;
  EXPECT_EQ(result.err.find("refused"), std::string::npos) << "nobody was asked for a connection: " << result.err;
}

/// What a program that asks for many system calls is told: a line "NAME refused", "NAME done" or "NAME failed" for
/// each.
std::string askedIn(const Sandbox& sandbox) {
  Confinement confinement;
  confinement.systemFolders = {"/usr/bin", "/usr/lib"};
  if (fs::exists("/usr/lib64")) confinement.systemFolders.emplace_back("/usr/lib64");
  confinement.files = {{"/given/asks", MUELLE_ASKS, "", true}};
  confinement.scratchBytes = 1 << 20;
  confinement.command = {"/usr/bin/sh", "-c", "exec given/asks tmp"};
  const CommandResult result = sandbox.run(confinement, {std::chrono::seconds(10), 65536, 65536, 0, false});
  EXPECT_EQ(result.status.code, 0) << result.err;
  return result.out;
}

TEST(LandlockBackend, RefusesModesTimesNamespacesRingsAndFilesInMemory) {
  const std::string reason = Landlock::whyNot();
  if (!reason.empty()) GTEST_SKIP() << reason;
  const std::string answers = askedIn(Landlock());
  EXPECT_EQ(answers.find(" done"), std::string::npos) << answers;
  EXPECT_EQ(answers.find(" failed"), std::string::npos) << answers;
  EXPECT_TRUE(answers.ends_with("memfd_secret refused\nend\n")) << answers;
  EXPECT_NE(askedIn(Unsafe()).find("chmod done\n"), std::string::npos) << "the program asks in a way that never works";
}

}  // namespace
}  // namespace muelle::grader
