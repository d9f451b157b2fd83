/// \file
/// The whole check, compiler included, on the exercise of fixture/ and the mistakes that students make.

#include "course/check/exercise_check.h"

#include "base/build_paths.h"
#include "base/file.h"
#include "course/check/compile_rules.h"
#include "course/check/fault_sentences.h"
#include "course/check/thrown_sentence.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <limits>

namespace muelle {
namespace {

const std::string twice = "Vec3 twice(const Vec3& x) { return 2 * x; }\n";
const std::string entry =
    "double entry(const std::vector<double>& list, int i) { return list[static_cast<std::size_t>(i)]; }\n";

class Check : public testing::Test {
 protected:
  StudentProgram build(const std::string& source) {
    writeFile(folder_.path() / "fixture_spring.cpp", "#include \"fixture_spring.h\"\n" + source);
    return buildStudentProgram(manifest_, {folder_.path() / "fixture_spring.cpp"}, folders_);
  }
  TestReport run(const std::string& source) {
    const StudentProgram program = build(source);
    EXPECT_FALSE(program.executable.empty()) << program.diagnostics;
    return runPublicTests(program);
  }
  /// The first message of the first failure.
  std::string firstMessage(const std::string& source) {
    const TestReport report = run(source);
    if (report.failures.empty()) return "none";
    return report.failures.front().messages.front();
  }
  void TearDown() override { std::filesystem::remove_all(folders_.out); }

  TemporaryFolder folder_{std::filesystem::path(build_paths::binary) / "test"};
  CheckFolders folders_{MUELLE_FIXTURE_EXERCISES, MUELLE_FIXTURE_BUILD, folder_.path() / "out"};
  Manifest manifest_ = [] {
    Manifest manifest;
    manifest.topic = "fixture_spring";
    manifest.files = {"fixture_spring.cpp"};
    return manifest;
  }();
};

/// The student's program is linked with the library of this build. AddressSanitizer brings an allocator of its own,
/// which neither fills fresh memory as ours does nor throws when there is none.
#ifdef __SANITIZE_ADDRESS__
constexpr bool hasOwnAllocator = true;
#else
constexpr bool hasOwnAllocator = false;
#endif

TEST_F(Check, ARightFilePassesAndLeavesItsCurve) {
  const StudentProgram program = build(twice + entry);
  EXPECT_EQ(program.diagnostics, "");
  const TestReport report = runPublicTests(program);
  EXPECT_TRUE(report.allPassed());
  EXPECT_EQ(report.total, 2);
  const CurvesReport curves = drawCurves(program, folders_.out, "you predicted: 0.2 s");
  EXPECT_EQ(curves.trouble, "");
  ASSERT_EQ(curves.figures.size(), 1U);
  EXPECT_NE(readFile(curves.figures[0]).find("you predicted: 0.2 s"), std::string::npos);
}

TEST_F(Check, ACurveThatCannotBeDrawnLeavesNoneOfAnEarlierCheck) {
  const CurvesReport drawn = drawCurves(build(twice + entry), folders_.out, "");
  ASSERT_EQ(drawn.figures.size(), 1U);
  writeFile(folders_.out / "swing.svg", "drawn by another command");
  const CurvesReport failed = drawCurves(build("Vec3 twice(const Vec3&) { throw 1; }\n" + entry), folders_.out, "");
  EXPECT_NE(failed.trouble, "");
  std::vector<std::string> left;
  for (const auto& file : std::filesystem::directory_iterator(folders_.out)) left.push_back(file.path().filename());
  std::ranges::sort(left);
  EXPECT_EQ(left, (std::vector<std::string>{"drawn.txt", "swing.svg"}));
}

TEST_F(Check, AWrongNumberIsACallToPaste) {
  const TestReport report = run("Vec3 twice(const Vec3& x) { return 3 * x; }\n" + entry);
  EXPECT_EQ(report.passed, 1);
  ASSERT_EQ(report.failures.size(), 1U);
  EXPECT_EQ(showFailure(report.failures[0]),
            "  every component is doubled\n"
            "    twice(Vec3(1, 2, 3));\n"
            "    component 0: got 3, expected 2 (difference 1, tolerance 1e-12)\n");
}

TEST_F(Check, AMistakeThatTheNumbersShowIsNamedInTheManifestsWords) {
  Misconception sign;
  sign.id = "wrong_sign";
  sign.function = "twice";
  Misconception halved;
  halved.id = "halved";
  halved.function = "twice";
  manifest_.misconceptions = {sign, halved};
  const auto named = [this](const std::string& source) {
    std::string ids;
    for (const Misconception& mistake : namedMistakes(run(source), manifest_)) ids += mistake.id + " ";
    return ids;
  };
  EXPECT_EQ(named("Vec3 twice(const Vec3& x) { return -2 * x; }\n" + entry), "wrong_sign ");
  EXPECT_EQ(named("Vec3 twice(const Vec3& x) { return x; }\n" + entry), "halved ");
  EXPECT_EQ(named("Vec3 twice(const Vec3& x) { return -x; }\n" + entry), "");
  EXPECT_EQ(named(twice + entry), "");
  EXPECT_EQ(named("Vec3 twice(const Vec3&) { Vec3 y; return y; }\n" + entry), "") << "never written: numbers are luck";
}

TEST_F(Check, ANumberThatIsOffArrivesAsANumber) {
  const TestReport report = run("Vec3 twice(const Vec3& x) { return Vec3(x[0] / 0.0, 0, 0); }\n" + entry);
  ASSERT_EQ(report.failures.size(), 1U);
  ASSERT_EQ(report.failures[0].mismatches.size(), 1U);
  const Mismatch& mismatch = report.failures[0].mismatches[0];
  EXPECT_EQ(mismatch.got, std::numeric_limits<double>::infinity());
  EXPECT_EQ(mismatch.expected, 2.0);
  EXPECT_EQ(mismatch.tolerance, 1e-12);
  EXPECT_EQ(mismatch.row, 0);
  EXPECT_EQ(mismatch.rows, 3);
  EXPECT_EQ(mismatch.call, "twice(Vec3(1, 2, 3))");
  EXPECT_TRUE(report.failures[0].messages.empty());
}

TEST_F(Check, AFileThatTheGraderHasNotIsNotFoundHereEither) {
  writeFile(folder_.path() / "helpers.h", "inline double one() { return 1; }\n");
  const std::string beside = (folder_.path() / "helpers.h").string();
  for (const std::string& included :
       {std::string("helpers.h"), beside, std::string("figures/write.h"), std::string("harness/../figures/write.h"),
        std::string("public_test.cpp"), std::string("fmt/format.h")}) {
    const StudentProgram program = build("#include \"" + included + "\"\n" + twice + entry);
    EXPECT_EQ(program.outcome, Outcome::Compile) << included;
    EXPECT_NE(program.message.find(included), std::string::npos) << program.message;
  }
  EXPECT_EQ(build("#include <bits/stdc++.h>\n#include <Eigen/Dense>\n#include <sys/types.h>\n" + twice + entry).message,
            "");
}

#if defined(__GNUC__) && !defined(__clang__) && !defined(__APPLE__)
TEST_F(Check, AFileThatTheAssemblerTakesInIsNamed) {
  const StudentProgram program =
      build("asm(\".section .rodata\\nfoo: .incbin \\\"/etc/passwd\\\"\\n.previous\");\n" + twice + entry);
  EXPECT_EQ(program.outcome, Outcome::Compile);
  EXPECT_NE(program.message.find("/etc/passwd"), std::string::npos) << program.message;
}
#endif

TEST(ShowFailure, LeavesTheSourceOutOnlyUnderItsCall) {
  FailedTest failure;
  Mismatch mismatch;
  mismatch.expression = "twice(x)";
  mismatch.got = 3.0;
  mismatch.expected = 2.0;
  mismatch.tolerance = 0.5;
  failure.mismatches = {mismatch};
  failure.call = "twice(1)";
  EXPECT_EQ(showFailure(failure), "    twice(1);\n    twice(x): got 3, expected 2 (difference 1, tolerance 0.5)\n");
  failure.mismatches[0].ofCall = true;
  EXPECT_EQ(showFailure(failure), "    twice(1);\n    got 3, expected 2 (difference 1, tolerance 0.5)\n");
  failure.call = "";
  EXPECT_EQ(showFailure(failure), "    twice: got 3, expected 2 (difference 1, tolerance 0.5)\n");
}

TEST(CountTests, TellsWhatWasNotRun) {
  TestReport report;
  EXPECT_EQ(countTests(report), "no public test ran");
  report.total = 9;
  report.passed = 3;
  EXPECT_EQ(countTests(report), "3 of 9 public tests pass");
  report.notRun = {"ThirdLaw.SumIsZero"};
  EXPECT_EQ(countTests(report), "3 of 9 public tests pass; 1 was not run: ThirdLaw.SumIsZero");
  report.notRun = {"A.a", "A.b", "B.a", "B.b", "C.a", "C.b", "D.a"};
  EXPECT_EQ(countTests(report), "3 of 9 public tests pass; 7 were not run: A.a, A.b, B.a, B.b, C.a, C.b and 1 more");
}

TEST(ShowFailure, ShowsTwoLinesAtMost) {
  FailedTest failure;
  failure.mismatches.resize(1);
  failure.messages = {"one", "two"};
  EXPECT_EQ(showFailure(failure), "    got 0, expected 0 (difference 0, tolerance 0)\n    one\n");
  failure.mismatches.resize(3);
  const std::string text = showFailure(failure);
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 2);
}

TEST_F(Check, AnErrorOfTheCompilerIsCut) {
  const StudentProgram program = build("Vec3 twice(const Vec3& x) { return x + 1.0; }\n" + entry);
  EXPECT_TRUE(program.executable.empty());
  EXPECT_NE(program.diagnostics.find("fixture_spring.cpp:2:38: error: no match for 'operator+'"), std::string::npos)
      << program.diagnostics;
  EXPECT_EQ(program.diagnostics.find("note:"), std::string::npos);
  EXPECT_EQ(program.diagnostics.find("Eigen/"), std::string::npos);
}

TEST_F(Check, AMissingFunctionIsNamed) {
  const StudentProgram program = build(twice);
  EXPECT_FALSE(program.executable.empty()) << "the other function is judged";
  EXPECT_NE(program.diagnostics.find("double entry(const std::vector<double>& list, int i)"), std::string::npos)
      << program.diagnostics;
}

TEST_F(Check, AnIndexOutOfRangeIsNamed) {
  EXPECT_EQ(firstMessage("Vec3 twice(const Vec3& x) { volatile int i = 3; return Vec3(x[i], 0, 0); }\n" + entry),
            "index 3 of a 3-vector in twice");
  EXPECT_EQ(firstMessage(twice + "double entry(const std::vector<double>& list, int) { return list[list.size()]; }\n"),
            "entry used an index beyond the end of a std::vector");
}

/// The tools of the compiler, nm aside, as the only ones that are found.
class WithoutNm {
 public:
  explicit WithoutNm(const std::filesystem::path& folder) {
    std::filesystem::create_directories(folder);
    for (const char* tool : {"as", "ld", "ld.bfd", "ld.gold", "ld.mold", "ld.lld", "mold"}) {
      const std::filesystem::path program = std::filesystem::path("/usr/bin") / tool;
      if (std::filesystem::exists(program)) std::filesystem::create_symlink(program, folder / tool);
    }
    setenv("PATH", folder.c_str(), 1);
  }
  WithoutNm(const WithoutNm&) = delete;
  WithoutNm& operator=(const WithoutNm&) = delete;
  ~WithoutNm() { setenv("PATH", path_.c_str(), 1); }

 private:
  std::string path_ = std::getenv("PATH");
};

TEST_F(Check, WithoutNmNothingPasses) {
  const WithoutNm surroundings(folder_.path() / "tools");
  try {
    build(twice + entry);
    FAIL() << "what the file uses was not looked at, and nobody said so";
  } catch (const std::runtime_error& error) {
    const std::string words = error.what();
    EXPECT_TRUE(words.starts_with("nm did not list what fixture_spring.cpp uses")) << words;
    EXPECT_NE(words.find("binutils"), std::string::npos) << words;
    EXPECT_EQ(words.find('\n'), std::string::npos) << words;
  }
}

/// Most that a child which has ended, or one of its own, had in memory [bytes].
std::size_t largestChild() {
  rusage usage{};
  getrusage(RUSAGE_CHILDREN, &usage);
#ifdef __APPLE__
  return static_cast<std::size_t>(usage.ru_maxrss);
#else
  return static_cast<std::size_t>(usage.ru_maxrss) * 1024;
#endif
}

const std::string allocatesWithoutEnd = R"(
Vec3 twice(const Vec3& x) {
  static std::vector<double*> kept;
  for (;;) {
    kept.push_back(new double[1 << 20]);
    for (int i = 0; i < 1 << 20; i += 256) kept.back()[i] = x[0];
  }
}
)";

/// Memory ends with an exception; on a machine that needs more than the 2 s of a call to fill 1 GiB, time ends before.
void expectOutOfMemory(const TestReport& report) {
  ASSERT_FALSE(report.failures.empty());
  const std::string& message = report.failures.front().messages.front();
  if (report.outcome == Outcome::Cpu) {
    EXPECT_EQ(message, "twice did not return within 2 s of processor time");
  } else {
    EXPECT_EQ(report.outcome, Outcome::Wrong);
    EXPECT_EQ(message, "twice threw an exception: std::bad_alloc");
  }
}

TEST_F(Check, MemoryIsBounded) {
  if (hasOwnAllocator) GTEST_SKIP() << "AddressSanitizer has an allocator of its own";
  expectOutOfMemory(run(allocatesWithoutEnd + entry));
  EXPECT_LT(largestChild(), std::size_t{1200} << 20U);
}

TEST_F(Check, MemoryIsBoundedWithSanitizersToo) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "the first build has the sanitizers, too: it ends without an exception";
#endif
  const std::string missingReturn = "int sign(int i);\nint sign(int i) { if (i > 0) return 1; }\n";
  const StudentProgram program = build(missingReturn + allocatesWithoutEnd + entry);
  ASSERT_FALSE(program.sanitized.empty()) << program.diagnostics;
  const TestReport report = runPublicTests(program);
  // What runs out in the second look confirms nothing: the word of the first stands.
  expectOutOfMemory(report);
  EXPECT_LT(largestChild(), std::size_t{1500} << 20U);
}

TEST_F(Check, TextOfAnotherEncodingIsReadAsTheGraderReadsIt) {
  std::string bytes = "\xff\xfe";
  for (const char c : "#include \"fixture_spring.h\"\n" + twice + entry) bytes += {c, '\0'};
  const std::filesystem::path file = folder_.path() / "fixture_spring.cpp";
  writeFile(file, bytes);
  const StudentProgram program = buildStudentProgram(manifest_, {file}, folders_);
  EXPECT_EQ(program.note, "fixture_spring.cpp: converted from UTF-16");
  ASSERT_FALSE(program.executable.empty()) << program.diagnostics;
  EXPECT_TRUE(runPublicTests(program).allPassed());
  EXPECT_EQ(readFile(file), bytes);
}

TEST_F(Check, WhatIsNoTextIsRefused) {
  const std::filesystem::path file = folder_.path() / "fixture_spring.cpp";
  writeFile(file, std::string("int\0a;", 6));
  StudentProgram program = buildStudentProgram(manifest_, {file}, folders_);
  EXPECT_EQ(program.outcome, Outcome::Refused);
  EXPECT_EQ(program.message, "fixture_spring.cpp is no text: byte 4 is NUL; save it as UTF-8");
  writeFile(file, twice + entry + std::string(300'000, '\n'));
  program = buildStudentProgram(manifest_, {file}, folders_);
  EXPECT_EQ(program.outcome, Outcome::Refused);
  EXPECT_EQ(program.message, "fixture_spring.cpp is larger than 256 KiB");
}

TEST_F(Check, WhatWaitsForEverIsNamed) {
  const std::string locks =
      "#include <mutex>\nVec3 twice(const Vec3& x) { static std::mutex m; m.lock(); m.lock(); return 2 * x; }\n";
  const TestReport report = run(locks + entry);
  EXPECT_EQ(report.outcome, Outcome::Crash);
  ASSERT_FALSE(report.failures.empty());
  EXPECT_EQ(report.failures.front().messages.front(), "twice waits without end for something that never comes");
}

TEST_F(Check, AnExceptionOfAMegabyteIsCut) {
  const TestReport report =
      run("#include <stdexcept>\nVec3 twice(const Vec3&) { throw std::runtime_error(std::string(1 << 20, 'x')); }\n" +
          entry);
  EXPECT_EQ(report.outcome, Outcome::Wrong);
  EXPECT_EQ(report.passed, 1);
  ASSERT_EQ(report.failures.size(), 1U);
  EXPECT_LT(report.failures[0].messages.front().size(), 10'000U);
}

TEST_F(Check, EndlessRecursionIsNamed) {
  EXPECT_EQ(
      firstMessage(twice + "double entry(const std::vector<double>& list, int i) { return 1 + entry(list, i); }\n"),
      std::string("entry ") + stackOverflowSentence);
}

TEST_F(Check, ALocalArrayLargerThanTheStackIsNamed) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "the stack is larger with sanitizers, and the array fits";
#endif
  EXPECT_EQ(firstMessage(twice +
                         "double entry(const std::vector<double>& list, int i) {\n"
                         "  volatile double copy[3000000];\n  copy[i] = list[std::size_t(i)];\n  return copy[i];\n}\n"),
            std::string("entry ") + stackOverflowSentence);
}

#ifdef __x86_64__
TEST_F(Check, AFloatingPointOperationThatIsMadeToTrapIsNoIntegerDivision) {
  EXPECT_EQ(firstMessage(twice + "#include <xmmintrin.h>\ndouble entry(const std::vector<double>&, int i) {\n"
                                 "  _mm_setcsr(_mm_getcsr() & ~unsigned(_MM_MASK_DIV_ZERO));\n"
                                 "  volatile double zero = 0;\n  return i / zero;\n}\n"),
            std::string("entry ") + trapSentence);
}
#endif

TEST_F(Check, WhatHappensAfterTheLastAnswerCostsNothing) {
  EXPECT_TRUE(
      run("namespace { struct Late { ~Late() { for (volatile int i = 1; i > 0;) {} } } late; }\n" + twice + entry)
          .allPassed());
  EXPECT_TRUE(run("namespace { struct Late { ~Late() { std::abort(); } } late; }\n" + twice + entry).allPassed());
}

TEST_F(Check, AnExceptionOfManyLinesIsShownOnOne) {
  const TestReport report =
      run("#include <stdexcept>\nVec3 twice(const Vec3&) { throw std::runtime_error(std::string(9000, '\\n')); }\n" +
          entry);
  ASSERT_EQ(report.failures.size(), 1U);
  const std::string shown = showFailure(report.failures[0]);
  EXPECT_LE(std::ranges::count(shown, '\n'), 4) << shown;
}

TEST_F(Check, AnEndlessLoopIsNamed) {
  EXPECT_EQ(firstMessage(
                twice +
                "double entry(const std::vector<double>&, int i) { volatile int n = i; while (n > 0) {} return n; }\n"),
            "entry " + limitSentence(std::chrono::seconds(2)));
}

TEST_F(Check, TheManifestSaysHowLongACallMayTake) {
  manifest_.callSeconds = 3;
  EXPECT_EQ(firstMessage(
                twice +
                "double entry(const std::vector<double>&, int i) { volatile int n = i; while (n > 0) {} return n; }\n"),
            "entry " + limitSentence(std::chrono::seconds(3)));
}

TEST_F(Check, ABadPointerAnExceptionAndAnExitAreNamed) {
  const std::string head = "double entry(const std::vector<double>&, int) { ";
  EXPECT_EQ(firstMessage(twice + head + "volatile double* p = nullptr; return *p; }\n"),
            std::string("entry ") + badMemorySentence);
  EXPECT_EQ(firstMessage(twice + head + "throw 3; }\n"), "entry " + thrownSentence(""));
  EXPECT_EQ(
      firstMessage("namespace { struct Bad : std::exception { const char* what() const noexcept override { return "
                   "nullptr; } }; }\n" +
                   twice + head + "throw Bad(); }\n"),
      "entry " + thrownSentence(""));
  EXPECT_EQ(firstMessage(twice + head + "throw std::runtime_error(\"not yet\"); }\n"),
            "entry threw an exception: not yet");
  EXPECT_EQ(firstMessage(twice + head + "std::exit(3); }\n"), "entry " + exitSentence(3));
  EXPECT_EQ(firstMessage(twice + head + "std::abort(); }\n"), std::string("entry ") + abortSentence);
}

TEST_F(Check, AnExceptionOutOfANoexceptFunctionIsNamed) {
  const std::string promises =
      "static void fails() { throw std::out_of_range(\"beyond\"); }\n"
      "static void promises() noexcept { fails(); }\n";
  EXPECT_EQ(
      firstMessage(promises + twice + "double entry(const std::vector<double>&, int) { promises(); return 0; }\n"),
      "entry " + uncaughtSentence("beyond"));
}

TEST_F(Check, WhatRunsWhenTheFileIsLoadedIsNamed) {
  const auto crash = [this](const std::string& code) {
    const TestReport report = run("static int early() { " + code + " }\nconst int loaded = early();\n" + twice + entry);
    EXPECT_EQ(countTests(report), "no public test ran");
    return report.crash;
  };
  const std::string subject = std::string(loadingCode) + " ";
  EXPECT_EQ(crash("std::abort();"), subject + abortSentence);
  EXPECT_EQ(crash("std::exit(0);"), subject + exitSentence(0));
  EXPECT_EQ(crash("throw std::out_of_range(\"no\");"), subject + uncaughtSentence("no"));
  EXPECT_EQ(crash("volatile int n = 1; while (n > 0) {} return n;"), subject + limitSentence(std::chrono::seconds(2)));
}

TEST_F(Check, WhatFollowsACrashIsRunAllTheSame) {
  const TestReport report = run("Vec3 twice(const Vec3&) { std::abort(); }\n" + entry);
  EXPECT_EQ(countTests(report), "1 of 2 public tests pass");
  ASSERT_EQ(report.failures.size(), 1U);
  EXPECT_EQ(report.failures[0].name, "DoublesEveryComponent");
  EXPECT_EQ(report.crash, std::string("twice ") + abortSentence);
  EXPECT_FALSE(report.allPassed());
  const TestReport both = run(
      "Vec3 twice(const Vec3&) { std::abort(); }\ndouble entry(const std::vector<double>&, int) { std::abort(); }\n");
  EXPECT_EQ(countTests(both), "0 of 2 public tests pass");
  EXPECT_EQ(both.failures.size(), 2U);
}

TEST_F(Check, AClassOfTheStudentsMayBeCalledAsAPublicTestIs) {
  EXPECT_TRUE(run("class Twice_DoublesEveryComponent_Test {\n public:\n  virtual void TestBody();\n};\n"
                  "void Twice_DoublesEveryComponent_Test::TestBody() {}\n" +
                  twice + entry)
                  .allPassed());
}

TEST_F(Check, ATestThatDidNotRunIsNoPass) {
  const TestReport report = run("namespace { struct Early { Early() { std::exit(0); } } early; }\n" + twice + entry);
  EXPECT_FALSE(report.allPassed());
  EXPECT_NE(report.crash, "");
}

TEST_F(Check, WhatTheStudentPrintsIsKeptApart) {
  const TestReport report = run("Vec3 twice(const Vec3& x) { std::puts(\"end\\tpassed\"); return 2 * x; }\n" + entry);
  EXPECT_TRUE(report.allPassed());
  EXPECT_EQ(report.output, "end\tpassed\n");
}

TEST_F(Check, UninitialisedMemoryIsNamedBeforeAnyOtherName) {
  if (hasOwnAllocator) GTEST_SKIP() << "AddressSanitizer has an allocator of its own";
  const std::string sentence =
      " returned memory to which nothing was written: give every variable a value before it is read";
  EXPECT_EQ(firstMessage("Vec3 twice(const Vec3& x) { Vec3 y; y[0] += 2 * x[0]; return y; }\n" + entry),
            "twice" + sentence);
  const TestReport report =
      run(twice +
          "double entry(const std::vector<double>& l, int i) { double* p = new double[8]; double s = p[2] + l[0] + i; "
          "delete[] p; return s; }\n");
  EXPECT_EQ(report.failures.at(0).messages.at(0), "entry" + sentence);
  EXPECT_EQ(report.outcome, Outcome::NeverWritten);
  EXPECT_EQ(run("Vec3 twice(const Vec3& x) { double f; f += 2; return f * x; }\n" + entry).outcome,
            Outcome::NeverWritten);
  EXPECT_EQ(
      run("Vec3 twice(const Vec3& x) { muelle::VecX y = x; y.conservativeResize(9); return 2 * x + y.tail<3>(); }\n" +
          entry)
          .outcome,
      Outcome::NeverWritten);
}

TEST_F(Check, AnExpressionOfTemporariesThatAreGoneIsConfirmedAtItsLine) {
  const std::string source =
      "static Vec3 same(const Vec3& x) { return x; }\n"
      "Vec3 twice(const Vec3& x) {\n"
      "  auto sum = same(x) + same(x);\n"
      "  return sum * (sum.norm() > 0 ? 1.0 : 0.0);\n"
      "}\n" +
      entry;
  const StudentProgram program = build(source);
  EXPECT_NE(program.diagnostics.find("fixture_spring.cpp:5"), std::string::npos) << program.diagnostics;
  ASSERT_FALSE(program.sanitized.empty());
  const TestReport report = runPublicTests(program);
  EXPECT_EQ(report.outcome, Outcome::Crash);
  ASSERT_FALSE(report.failures.empty());
  EXPECT_TRUE(report.failures[0].messages[0].starts_with("fixture_spring.cpp:5 uses a temporary"))
      << report.failures[0].messages[0];
}

/// All tests of the first build pass.
TEST_F(Check, WhatOnlyTheSecondLookFindsFailsTheTestThatCallsIt) {
  const std::string readsGone =
      "static const double& first(const std::vector<double>& v) { return v[0]; }\n"
      "Vec3 twice(const Vec3& x) {\n"
      "  std::vector<double> v{1};\n  const double& r = first(v);\n  v.resize(1000);\n"
      "  volatile double gone = r;\n  (void)gone;\n  return 2 * x;\n}\n";
  const TestReport report = run(readsGone + entry);
  EXPECT_EQ(report.outcome, Outcome::Crash);
  EXPECT_EQ(countTests(report), "1 of 2 public tests pass");
  ASSERT_EQ(report.failures.size(), 1U);
  EXPECT_EQ(report.failures[0].suite + "." + report.failures[0].name, "Twice.DoublesEveryComponent");
  EXPECT_EQ(report.failures[0].property, "every component is doubled");
  EXPECT_EQ(report.failures[0].call, "twice(Vec3(1, 2, 3))");
  EXPECT_TRUE(report.failures[0].messages.at(0).starts_with("fixture_spring.cpp:7 uses memory that was given back"))
      << report.failures[0].messages.at(0);
}

TEST_F(Check, AMissingReturnIsConfirmedAtItsFunction) {
  const TestReport report =
      run(twice + "double entry(const std::vector<double>& l, int i) { if (i > 5) return l[0]; }\n");
  EXPECT_EQ(report.outcome, Outcome::Crash);
  ASSERT_FALSE(report.failures.empty());
  EXPECT_NE(report.failures[0].messages[0].find("ends without returning a value"), std::string::npos)
      << report.failures[0].messages[0];
}

TEST_F(Check, AWarningThatNothingConfirmsCostsNothing) {
  const StudentProgram program =
      build(twice + "double entry(const std::vector<double>& l, int i) { if (i < 9) return l[1]; }\n");
  EXPECT_FALSE(program.sanitized.empty());
  EXPECT_TRUE(runPublicTests(program).allPassed());
}

/// Temporaries that are gone, of which GCC 12 warns at the second line.
const std::string readsWhatIsGone =
    "Vec3 twice(const Vec3& x) { auto sum = same(x) + same(x);\n"
    "  return sum * (sum.norm() > 0 ? 1.0 : 0.0); }\n";
const std::string same = "static Vec3 same(const Vec3& x) { return x; }\n";

TEST_F(Check, AWarningThatIsSwitchedOffIsConfirmedAllTheSame) {
  for (const char* hides : {"#pragma GCC diagnostic ignored \"-Wuninitialized\"\n", "#line 1 \"other.cpp\"\n"}) {
    const TestReport report = run(hides + same + readsWhatIsGone + entry);
    EXPECT_EQ(report.outcome, Outcome::Crash) << hides;
  }
}

TEST_F(Check, WordsWithoutEndHideNoWarning) {
  std::string flood;
  for (int i = 0; i < 700; ++i) flood += "static int f" + std::to_string(i) + "() { int unusedVariable; return 0; }\n";
  EXPECT_EQ(run(flood + same + readsWhatIsGone + entry).outcome, Outcome::Crash);
}

TEST_F(Check, WordsOfTheLinkerWithoutEndAreAVerdict) {
  std::string declared;
  std::string used;
  for (int i = 0; i < 700; ++i) {
    declared += "double aHelperThatIsNowhere" + std::to_string(i) + "(double);\n";
    used += " + aHelperThatIsNowhere" + std::to_string(i) + "(x[0])";
  }
  EXPECT_EQ(build(declared + "Vec3 twice(const Vec3& x) { return x * (2" + used + "); }\n" + entry).outcome,
            Outcome::Link);
}

TEST_F(Check, ASourceCannotAskForTheSanitizers) {
  const std::string asks = "#ifdef __SANITIZE_ADDRESS__\n#error no\n#endif\n";
  const StudentProgram program = build(asks + same + readsWhatIsGone + entry);
  EXPECT_FALSE(program.sanitized.empty()) << program.diagnostics;
  EXPECT_EQ(runPublicTests(program).outcome, Outcome::Crash);
}

TEST_F(Check, WhatDoesNotBuildWithSanitizersLosesNothing) {
#ifndef __x86_64__
  GTEST_SKIP() << "the assembler is x86's";
#endif
  // The second build needs the register for its frames.
  const std::string refuses =
      "double outer(double x);\ndouble outer(double x) { asm(\"\" : : : \"rbp\"); return x; }\n";
  const StudentProgram program = build(refuses + twice + entry);
  EXPECT_EQ(program.outcome, Outcome::Passed);
  EXPECT_TRUE(program.sanitized.empty());
  EXPECT_NE(program.diagnostics.find("not looked at a second time"), std::string::npos) << program.diagnostics;
  EXPECT_TRUE(runPublicTests(program).allPassed());
}

TEST_F(Check, ProcessorTimeAndStackOfTheSecondLookConfirmNothing) {
  const std::string alarm =
      "enum class Mode { A, B };\nint f(Mode m);\n"
      "int f(Mode m) { switch (m) { case Mode::A: return 1; case Mode::B: return 2; } }\n";
  const std::string deep =
      "#include <cstdio>\n"
      "double deep(int n);\ndouble deep(int n) { double s[8]; char t[32]; for (int i = 0; i < 8; ++i) s[i] = n + i;\n"
      "  if (n == 0) return 0; double below = deep(n - 1); std::snprintf(t, sizeof t, \"%d\", n);\n"
      "  return below + 0.0 * s[n % 8] + 0.0 * t[0]; }\n"
      "double entry(const std::vector<double>& l, int i) { return l.at(static_cast<std::size_t>(i)) + deep(30000); }\n";
  const StudentProgram program = build(alarm + twice + deep);
  EXPECT_FALSE(program.sanitized.empty());
  EXPECT_TRUE(runPublicTests(program).allPassed());
}

TEST_F(Check, AFlagThatIsNotSetOnEveryWayIsNamed) {
  const std::string flag =
      "double entry(const std::vector<double>& l, int i) { bool last; if (i > 1) last = true;\n"
      "  return l.at(static_cast<std::size_t>(i)) * (last ? 0 : 1); }\n";
  const TestReport report = run(twice + flag);
  EXPECT_EQ(report.outcome, Outcome::NeverWritten);
  ASSERT_FALSE(report.failures.empty());
  EXPECT_EQ(report.failures.front().messages.front(),
            "fixture_spring.cpp:4 reads a bool or an enum to which nothing was written: give every variable a value "
            "before it is read");
}

/// GCC would take it for what another branch assigns.
TEST_F(Check, ANumberThatIsNotSetOnEveryWayIsNamed) {
  const std::string sign =
      "double entry(const std::vector<double>& l, int i) { double sign; if (i > 5) sign = 1;\n"
      "  return l.at(static_cast<std::size_t>(i)) * sign; }\n";
  const StudentProgram program = build(twice + sign);
  EXPECT_NE(program.diagnostics.find("may be used uninitialized"), std::string::npos) << program.diagnostics;
  EXPECT_EQ(runPublicTests(program).outcome, Outcome::NeverWritten);
}

TEST_F(Check, ABrokenHeapIsToldInTheLibrarysWords) {
  if (hasOwnAllocator) GTEST_SKIP() << "AddressSanitizer has an allocator of its own";
  const TestReport report =
      run(twice +
          "double entry(const std::vector<double>& l, int i) { volatile double* p = new double[4];\n"
          "  for (int j = -2; j < 9; ++j) p[j] = l.at(0); delete[] p; return i; }\n");
  EXPECT_EQ(report.outcome, Outcome::Crash);
  EXPECT_TRUE(report.crash.starts_with("entry damaged the heap: ")) << report.crash;
}

TEST_F(Check, WhatNoExerciseNeedsIsRefusedByItsName) {
  const StudentProgram reads =
      build("#include <iostream>\n" + twice + entry + "int n() { int i; std::cin >> i; return i; }\n");
  EXPECT_TRUE(reads.executable.empty());
  EXPECT_EQ(reads.outcome, Outcome::Forbidden);
  EXPECT_EQ(reads.message, "it reads the keyboard (std::cin): nobody types while it is tested");
  const StudentProgram main = build(twice + entry + "int main() { return 0; }\n");
  EXPECT_EQ(main.outcome, Outcome::Link);
  EXPECT_EQ(main.message, "your file defines main: leave it out");
  EXPECT_EQ(build("#include <iostream>\n" + twice + entry + "void p() { std::cout << 1; }\n").outcome, Outcome::Passed);
}

TEST_F(Check, TheOutcomeHasTheGradersClass) {
  EXPECT_EQ(run(twice + entry).outcome, Outcome::Passed);
  EXPECT_EQ(run("Vec3 twice(const Vec3& x) { return x; }\n" + entry).outcome, Outcome::Wrong);
  EXPECT_EQ(run(twice + "double entry(const std::vector<double>& l, int) { return l[9]; }\n").outcome, Outcome::Crash);
  EXPECT_EQ(run(twice +
                "double entry(const std::vector<double>&, int i) { volatile int n = i; while (n > 0) {} return n; }\n")
                .outcome,
            Outcome::Cpu);
  EXPECT_EQ(build("int x = ;\n").outcome, Outcome::Compile);
  EXPECT_EQ(run(twice).outcome, Outcome::Link);
}

TEST_F(Check, EndlessPrintingIsCutAndCostsOnlyItsTime) {
  const TestReport report = run(
      twice +
      "double entry(const std::vector<double>& l, int i) { for (int n = 0; n < 200000; ++n) std::puts(\"x\"); return "
      "l[static_cast<std::size_t>(i)]; }\n");
  EXPECT_TRUE(report.allPassed());
  EXPECT_LE(report.output.size(), 65536U);
}

TEST_F(Check, APathWithBlanksQuotesAndAccentsLinks) {
  const std::filesystem::path place = folder_.path() / "una \"carpeta\" de mañana, o'clock";
  std::string parts;
  std::filesystem::create_directories(place / "build/check");
  for (const std::string& part : readParts(readFile(folders_.build / "check/fixture_spring.parts"))) {
    // Two targets may give their objects one name.
    const std::filesystem::path moved = place / (std::to_string(parts.size()) + ".o");
    const bool isObject = part.ends_with(".o");
    if (isObject) std::filesystem::copy_file(part, moved, std::filesystem::copy_options::overwrite_existing);
    parts += (isObject ? moved.string() : part) + "\n";
  }
  writeFile(place / "build/check/fixture_spring.parts", parts);
  writeFile(place / "fixture_spring.cpp", "#include \"fixture_spring.h\"\n" + twice + entry);
  const CheckFolders folders{folders_.exercises, place / "build", place / "out"};
  const StudentProgram program = buildStudentProgram(manifest_, {place / "fixture_spring.cpp"}, folders);
  ASSERT_FALSE(program.executable.empty()) << program.diagnostics;
  EXPECT_TRUE(runPublicTests(program).allPassed());
}

/// Without it the linker would name what the contract names, and the student would be blamed.
TEST_F(Check, AnObjectOfOursThatIsMissingIsNotTheFilesFault) {
  const std::filesystem::path build = folder_.path() / "build";
  std::filesystem::create_directories(build / "check");
  writeFile(build / "check/fixture_spring.parts", "public_test.cpp.o\n");
  writeFile(folder_.path() / "fixture_spring.cpp", "#include \"fixture_spring.h\"\n" + twice + entry);
  const CheckFolders folders{folders_.exercises, build, folder_.path() / "out"};
  try {
    buildStudentProgram(manifest_, {folder_.path() / "fixture_spring.cpp"}, folders);
    FAIL() << "nothing is missed";
  } catch (const std::runtime_error& error) {
    EXPECT_EQ(std::string(error.what()).find("fixture_spring is not in the build (public_test.cpp.o was not made)"), 0U)
        << error.what();
  }
}

TEST_F(Check, AnUnchangedFileIsNotCompiledAgain) {
  const StudentProgram first = build(twice + entry);
  const auto built = std::filesystem::last_write_time(first.executable);
  const StudentProgram again = buildStudentProgram(manifest_, {folder_.path() / "fixture_spring.cpp"}, folders_);
  EXPECT_EQ(std::filesystem::last_write_time(again.executable), built);
  EXPECT_EQ(again.fingerprint, first.fingerprint);
  const StudentProgram changed = build(twice + entry + "// more\n");
  EXPECT_NE(changed.fingerprint, first.fingerprint);
  EXPECT_NE(std::filesystem::last_write_time(changed.executable), built);
}

}  // namespace
}  // namespace muelle
