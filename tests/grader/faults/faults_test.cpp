/// \file
/// Faults of the machine, staged: an honest submission never gets a wrong score and has full marks when the same
/// command is run again; a wrong one gets what it gets on a machine where all is well.

#include "hunter.h"
#include "small_disk.h"
#include "staged.h"

#include <algorithm>
#include <csignal>
#include <optional>
#include <set>
#include <vector>

namespace muelle::grader {
namespace {

/// Runs a staged fault, then the machine as it should be, for both submissions.
class Fault : public StagedFault {
 protected:
  /// Graded until the fault has struck: on a busy machine who is to kill may be late for a process that is short, and
  /// then the score is the right one.
  template <class Stage>
  GradedExercise gradeUnder(Stage stage, const Sources& sources) {
    constexpr int tries = 5;
    for (int i = 1;; ++i) {
      auto staged = std::make_optional(stage());
      GradedExercise graded = grade(sources);
      staged.reset();
      if (i == tries || hasGraderFault(graded)) return graded;
      expectNothingWrong(graded, sources);
      remove_all(workplace_.kept);
    }
  }

  template <class Stage, class Mend>
  void expectOurs(Stage stage, Mend mend) {
    for (const Sources* sources : {&honest(), &wrong()}) {
      expectNoScore(gradeUnder(stage, *sources));
      mend();
      expectUndisturbed(grade(*sources), *sources);
    }
  }
};

struct Nothing {};

TEST_F(Fault, ACompilerThatIsKilled) {
  expectOurs([] { return std::make_unique<Hunter>("cc1plus", SIGKILL); }, [] {});
}

/// Twice is no proof against the submission, whichever process of the compilation it was.
TEST_F(Fault, AnyToolThatIsKilledTwice) {
  const std::string driver = workplace_.compiler.filename();
  for (const auto& [name, signal] :
       std::map<std::string, int>{{"cc1plus", SIGKILL}, {"sh", SIGTERM}, {"watch", SIGKILL}, {driver, SIGTERM}}) {
    SCOPED_TRACE(name);
    for (const Sources* sources : {&honest(), &wrong()}) {
      {
        const Hunter hunter(name, signal, 2);
        expectNoScore(grade(*sources));
      }
      expectUndisturbed(grade(*sources), *sources);
      remove_all(workplace_.kept);
    }
  }
}

/// What ends so soon that the signal may come too late: no score, or the right one.
TEST_F(Fault, AShortToolThatIsKilledTwice) {
  for (const char* name : {"as", "nm", "collect2", "ld.mold", "mold", "ld"}) {
    SCOPED_TRACE(name);
    for (const Sources* sources : {&honest(), &wrong()}) {
      auto hunter = std::make_unique<Hunter>(name, SIGKILL, 2);
      const GradedExercise graded = grade(*sources);
      hunter.reset();  // what it is compared with is graded in peace
      expectNothingWrong(graded, *sources);
      remove_all(workplace_.kept);
    }
  }
}

/// What a file makes its compiler say of a death is no death.
TEST_F(Fault, AFileThatSpeaksOfADeathIsJudgedByItself) {
  Sources sources = honest();
  sources.begin()->second +=
      "#line 1 \"g++: fatal error: Killed signal terminated program cc1plus\"\n#error compilation terminated.\n";
  EXPECT_EQ(grade(sources).build.status, BuildOutcome::Status::CompileError);
}

TEST_F(Fault, ACompilerThatIsKilledOnceIsTriedAgainAtOnce) {
  for (const Sources* sources : {&honest(), &wrong()}) {
    const Hunter hunter("cc1plus", SIGKILL, 1);
    expectUndisturbed(grade(*sources), *sources);
    EXPECT_EQ(hunter.hits(), 1);
  }
}

TEST_F(Fault, ACompilerThatIsStoppedPastItsWallLimit) {
  expectOurs(
      [this] {
        workplace_.limits.wall = std::chrono::seconds(2);
        return std::make_unique<Hunter>("cc1plus", SIGSTOP);
      },
      [this] { workplace_.limits = CompileLimits(); });
}

/// What one criterion finds out of a function takes no points from another, whichever is judged first.
TEST_F(Fault, AFunctionThatDoesNotReturnForSomeInputsCostsWhatAsksForThese) {
  takeAllCriteria();
  Sources sources = honest();
  std::string& text = sources.begin()->second;
  const std::string guard = "if (L == 0) return 0;";
  const std::size_t at = text.find(guard);
  ASSERT_NE(at, std::string::npos);
  text.replace(at, guard.size(), "while (L == 0) {}");
  std::set<std::vector<std::optional<double>>> rows;
  for (const int jobs : {1, 3}) {
    std::vector<std::optional<double>> row;
    const GradedExercise graded = grade(sources, jobs);
    for (const Criterion& criterion : graded.manifest.criteria) row.push_back(score(criterion, graded));
    rows.insert(row);
    const auto lost = std::count(row.begin(), row.end(), 0.0);
    EXPECT_EQ(lost, 1) << "only the coincident nodes, with " << jobs << " jobs";
    remove_all(workplace_.kept);
  }
  EXPECT_EQ(rows.size(), 1u);
}

TEST_F(Fault, AWorkerThatIsKilled) {
  expectOurs([] { return std::make_unique<Hunter>("host", SIGKILL); }, [] {});
}

/// By hand, or by a stranger's script: the process tells that it did not do so itself, which is believed once.
TEST_F(Fault, AWorkerThatIsStruckOnceIsTriedAgainAtOnce) {
  for (const int signal : {SIGSEGV, SIGABRT, SIGTRAP, SIGXCPU, SIGTERM}) {
    for (const Sources* sources : {&honest(), &wrong()}) {
      const Hunter hunter("host", signal, 1);
      expectUndisturbed(grade(*sources), *sources);
      EXPECT_EQ(hunter.hits(), 1);
      remove_all(workplace_.kept);
    }
  }
}

TEST_F(Fault, AWorkerThatIsStoppedPastItsWallLimit) {
  expectOurs(
      [this] {
        workplace_.callWall = std::chrono::milliseconds(700);
        return std::make_unique<Hunter>("host", SIGSTOP);
      },
      [this] { workplace_.callWall = Workplace::ofThisBuild().callWall; });
}

TEST_F(Fault, ATestProcessThatIsKilled) {
  expectOurs([this] { return std::make_unique<Hunter>("hidden_" + exercise_.topic, SIGKILL); }, [] {});
}

/// What a broken tool says and how it ends: none of it is the student's word.
TEST_F(Fault, ACompilerThatBreaks) {
  for (const char* script : {
           "kill -9 $$",
           "kill -SEGV $$",
           "echo 'g++: fatal error: Killed signal terminated program cc1plus' >&2; exit 1",
           "echo \"$PWD: internal compiler error: Segmentation fault\" >&2; exit 4",
           "echo 'cc1plus: out of memory allocating 65536 bytes after a total of 1 bytes' >&2; exit 1",
           "echo '/tmp/x.s: fatal error: error writing to /tmp/x.s: No space left on device' >&2; exit 1",
           "exit 127",
       }) {
    SCOPED_TRACE(script);
    expectOurs(
        [&] {
          putInCompilersPlace(script);
          return Nothing{};
        },
        [this] { putCompilerBack(); });
  }
}

TEST_F(Fault, NoCompiler) {
  expectOurs(
      [this] {
        workplace_.compiler = "/usr/bin/there-is-no-such-compiler";
        return Nothing{};
      },
      [this] { putCompilerBack(); });
}

TEST_F(Fault, NoLinker) {
  expectOurs(
      [this] {
        putInCompilersPlace(
            "for word in \"$@\"; do\n  if [ \"$word\" = -c ]; then exec $compiler \"$@\"; fi\ndone\n"
            "echo \"collect2: fatal error: cannot find 'ld'\" >&2\nexit 1");
        return Nothing{};
      },
      [this] { putCompilerBack(); });
}

/// A file that makes the compiler crash each time is its author's: a known good one compiles at the same time.
TEST_F(Fault, ACompilerThatDiesOfOneFileTwiceIsThatFilesFault) {
  putInCompilersPlace(
      "for word in \"$@\"; do\n  if grep -q 'kills the compiler' \"$word\"; then\n"
      "    ../tools/watch sh -c 'kill -SEGV $$'; exit 4\n  fi\ndone\nexec $compiler \"$@\"");
  Sources sources = honest();
  sources.begin()->second += "// kills the compiler\n";
  const GradedExercise graded = grade(sources);
  EXPECT_EQ(graded.build.status, BuildOutcome::Status::CompileError) << graded.build.message;
  for (const Criterion& criterion : graded.manifest.criteria) EXPECT_EQ(score(criterion, graded), 0.0);
  expectUndisturbed(grade(honest()), honest());
}

/// What a disk has made of a kept object is not loaded: it is built again, and the next run finds that.
TEST_F(Fault, AKeptObjectThatIsDamaged) {
  const auto damageAll = [this](std::uintmax_t bytes) {
    for (const auto& entry : std::filesystem::recursive_directory_iterator(workplace_.objects())) {
      if (entry.path().extension() == ".so") resize_file(entry.path(), bytes);
    }
    remove_all(workplace_.records());
  };
  for (const Sources* sources : {&honest(), &wrong()}) {
    expectUndisturbed(grade(*sources), *sources);
    for (const std::uintmax_t bytes : {0U, 9000U, 1U << 20U}) {
      SCOPED_TRACE(bytes);
      damageAll(bytes);
      expectUndisturbed(grade(*sources), *sources);
      grade(*sources);
      EXPECT_EQ(started(), 0) << "what was built again is kept";
    }
  }
}

/// Whatever is kept: a file whose reading fails (as address 0 of a process does) is made again.
TEST_F(Fault, AKeptFileThatCannotBeRead) {
  for (const Sources* sources : {&honest(), &wrong()}) {
    grade(*sources, SandboxChoice::Automatic, true);
    for (const auto& folder : {workplace_.objects(), workplace_.records()}) {
      for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
        if (!entry.is_regular_file()) continue;
        remove(entry.path());
        create_symlink("/proc/self/mem", entry.path());
      }
    }
    expectUndisturbed(grade(*sources, SandboxChoice::Automatic, true), *sources);
    grade(*sources, SandboxChoice::Automatic, true);
    EXPECT_EQ(started(), 0);
  }
}

/// From no room at all to so much that the object is still built and a record is not.
TEST_F(Fault, AFullDisk) {
  std::filesystem::create_directories(workplace_.kept);
  const SmallDisk disk(workplace_.kept, 64UL << 20);
  if (!disk.isMounted()) GTEST_SKIP() << "only root mounts a small disk";
  for (const std::size_t left : {0UL, 16UL << 10, 256UL << 10, 1UL << 20}) {
    SCOPED_TRACE(left);
    for (const auto& entry : std::filesystem::directory_iterator(workplace_.kept)) remove_all(entry.path());
    for (const Sources* sources : {&honest(), &wrong()}) {
      disk.fill(left);
      const GradedExercise graded = grade(*sources);
      expectNothingWrong(graded, *sources);
      if (left == 0) expectNoScore(graded);
      disk.empty();
      expectUndisturbed(grade(*sources), *sources);
    }
  }
}

/// A student who saves while the grader works is graded for one of the two files, whole.
TEST_F(Fault, AFileThatChangesWhileItIsGraded) {
  takeAllCriteria();
  const std::filesystem::path handIn = folder_.path() / "hand-in";
  const std::string& name = exercise_.files.front();
  for (const Sources* sources : {&honest(), &wrong()}) {
    const Sources& other = sources == &honest() ? wrong() : honest();
    std::filesystem::create_directories(handIn);
    writeFile(handIn / name, sources->at(name));
    GradeOptions options;
    options.seed = "staged faults";
    options.withCurves = false;
    Grader grader = openGrader(workplace_, options, {exercise_.topic});
    const Submission taken = grader.take(handIn);
    writeFile(handIn / name, other.at(name));
    expectUndisturbed(muelle::grader::grade(grader, taken, 2).exercises.front(), *sources);
  }
}

/// What was compiled without a sandbox, where a file could read all that its author may not, serves nobody within one.
TEST_F(Fault, AnObjectOfAnotherSandboxIsBuiltAgain) {
  expectUndisturbed(grade(honest(), SandboxChoice::Unsafe), honest());
  const int unsafe = started();
  expectUndisturbed(grade(honest()), honest());
  EXPECT_EQ(started(), unsafe) << "the object or the verdicts of the run without a sandbox were taken";
  expectUndisturbed(grade(honest()), honest());
  EXPECT_EQ(started(), 0) << "an unchanged regrade starts nothing";
}

/// A sandbox that stops to work after it was tried.
class BrokenSandbox : public Sandbox {
 public:
  std::string description() const override { return "broken"; }
  SandboxChoice choice() const override { return makeSandbox(SandboxChoice::Automatic)->choice(); }

 protected:
  Prepared prepare(const Confinement&) const override { throw std::runtime_error("no namespaces are left"); }
};

TEST_F(Fault, ASandboxThatRefuses) {
  for (const Sources* sources : {&honest(), &wrong()}) {
    expectNoScore(grade(*sources, std::make_unique<BrokenSandbox>(), SandboxChoice::Automatic));
    expectUndisturbed(grade(*sources), *sources);
  }
}

TEST_F(Fault, ATestProgramThatIsGone) {
  const std::filesystem::path binary = workplace_.binary;
  expectOurs(
      [&] {
        workplace_.binary = folder_.path() / "nowhere";
        return Nothing{};
      },
      [&] { workplace_.binary = binary; });
}

}  // namespace
}  // namespace muelle::grader
