/// \file
/// The compiler in the sandbox: what it can see, and that it ends. The worker's folder is thrown away afterwards.

#include "grader/run/build_worker.h"

#include "base/file.h"
#include "grader/run/grade.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

namespace muelle::grader {
namespace {

namespace fs = std::filesystem;

class Compiling : public ::testing::Test {
 protected:
  Compiling() : workplace_(Workplace::ofThisBuild()), exercise_(readCourse(workplace_.exercises()).front()) {
    workplace_.kept = kept_.path();
  }

  BuildOutcome build(const std::string& source) const {
    const char* name = std::getenv("MUELLE_SANDBOX");
    const auto sandbox = makeSandbox(parseSandboxChoice(name != nullptr ? name : ""));
    GradeOptions options;
    options.sandbox = sandbox->choice();
    const Sources sources{{exercise_.files.front(), "#include \"" + exercise_.topic + ".h\"\n" + source}};
    const Store store(workplace_.objects());
    const BuildOutcome outcome =
        buildObject(workplace_, store, exercise_, sources, *sandbox, options, true).object.outcome;
    EXPECT_NE(outcome.status, BuildOutcome::Status::GraderFault) << outcome.message;
    return outcome;
  }

  TemporaryFolder kept_{fs::temp_directory_path()};
  Workplace workplace_;
  const Manifest exercise_;
};

/// Asks for each path whether it exists. What the compiler may know of is there, so that the test can fail.
TEST_F(Compiling, SeesTheContractAndNothingOfTheProject) {
  const std::string checkout = workplace_.source.string();
  const char* home = std::getenv("HOME");
  std::string source;
  for (const std::string& path :
       {checkout + "/tests/hidden/" + exercise_.topic + "/oracle.cpp",
        checkout + "/solutions/" + exercise_.topic + "/" + exercise_.files.front(),
        workplace_.contract(exercise_.topic).string(), checkout + "/CMakeLists.txt", workplace_.seedFile().string(),
        std::string("/etc/passwd"), std::string("/etc/shadow"), std::string("/proc/self/maps"),
        std::string("/proc/self/environ"), std::string("/dev/zero"),
        (home != nullptr ? std::string(home) : "") + "/.profile", "../tests/hidden/" + exercise_.topic + "/oracle.cpp",
        "../../solutions/" + exercise_.topic + "/" + exercise_.files.front(), std::string("oracle.cpp"),
        std::string("grader/wire/codec.h"), std::string("engine/model/model.h")}) {
    source += "#if __has_include(\"" + path + "\")\n#error visible: " + path + "\n#endif\n";
  }
  const BuildOutcome hidden = build(source + "#error the end was reached\n");
  EXPECT_EQ(hidden.diagnostics.find("visible"), std::string::npos) << hidden.diagnostics;
  EXPECT_NE(hidden.diagnostics.find("the end was reached"), std::string::npos) << hidden.message;
  const BuildOutcome seen =
      build("#if __has_include(\"harness/exercise.h\") && __has_include(<Eigen/Core>)\n#error seen\n#endif\n");
  EXPECT_NE(seen.diagnostics.find("seen"), std::string::npos);
}

TEST_F(Compiling, EmbedsNoFileOfTheMachine) {
  for (const std::string& path : {workplace_.source.string() + "/CMakeLists.txt", std::string("/etc/passwd"),
                                  std::string("/proc/self/environ"), std::string("/dev/urandom")}) {
    const BuildOutcome outcome = build("asm(\".incbin \\\"" + path + "\\\"\");\n");
    EXPECT_EQ(outcome.status, BuildOutcome::Status::CompileError) << path;
  }
}

TEST_F(Compiling, EndsAtItsTimeLimit) {
  workplace_.limits.processorTime = std::chrono::seconds(2);
  // Twofold at every level: the depth limit is never reached, the time is.
  const char* bomb =
      "template <int N, int M> struct Wide { static constexpr int v = Wide<N - 1, 2 * M>::v + Wide<N - 1, 2 * M + "
      "1>::v; };\n"
      "template <int M> struct Wide<0, M> { static constexpr int v = M; };\nint w = Wide<28, 0>::v;\n";
  const auto start = std::chrono::steady_clock::now();
  const BuildOutcome outcome = build(bomb);
  EXPECT_EQ(outcome.status, BuildOutcome::Status::CompileError);
  EXPECT_NE(outcome.message.find("2 s of processor time"), std::string::npos) << outcome.message;
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(60));
}

TEST_F(Compiling, EndsAtItsMemoryLimit) {
  workplace_.limits.memory = 300UL << 20;
  const BuildOutcome outcome = build(
      "template <int N, int M> struct Wide { static constexpr int v = Wide<N - 1, 2 * M>::v + Wide<N - 1, 2 * M + "
      "1>::v; };\n"
      "template <int M> struct Wide<0, M> { static constexpr int v = M; };\nint w = Wide<28, 0>::v;\n");
  EXPECT_EQ(outcome.status, BuildOutcome::Status::CompileError) << outcome.message;
}

TEST_F(Compiling, DiagnosticsAreCut) {
  std::string source;
  for (int i = 0; i < 200; ++i)
    source += "int f" + std::to_string(i) + "() { return " + std::string(3000, 'x') + "; }\n";
  const BuildOutcome outcome = build(source);
  EXPECT_EQ(outcome.status, BuildOutcome::Status::CompileError);
  EXPECT_LE(outcome.diagnostics.size() + outcome.message.size(), 2U * 64 * 1024);
}

TEST_F(Compiling, ProductsAreBounded) {
  workplace_.limits.product = 4 << 20;
  // The solution with ballast: everything else about it is right.
  const fs::path solution = workplace_.source / "solutions" / exercise_.topic / exercise_.files.front();
  const BuildOutcome outcome = build(readFile(solution) + "\nextern const char ballast[8 << 20] = {1};\n");
  EXPECT_EQ(outcome.status, BuildOutcome::Status::CompileError);
  EXPECT_NE(outcome.message.find("larger than 4 MiB"), std::string::npos) << outcome.message;
}

}  // namespace
}  // namespace muelle::grader
