#include "course/check/second_look.h"

#include "base/build_paths.h"
#include "base/file.h"
#include "course/check/source_tokens.h"

#include <gtest/gtest.h>

namespace muelle {
namespace {

namespace fs = std::filesystem;

bool asksFor(const std::string& source, const std::string& words = "", bool wordsCut = false) {
  ToolRun run;
  run.succeeded = true;
  run.words = words;
  run.wordsCut = wordsCut;
  return wantsSecondLook(run, {{"spring_3d.cpp", source}});
}

TEST(SourceTokens, CommentsTextsAndSplicesAreNone) {
  const std::vector<std::string_view> tokens{"#", "pragma", "x", "1'000", ";", "f", "(", ")"};
  EXPECT_EQ(sourceTokens("#pra/* \" */ // '\n"), (std::vector<std::string_view>{"#", "pra"}));
  EXPECT_EQ(withoutSplices("a\\\nb\\ \r\nc\\d"), "abc\\d");
  EXPECT_EQ(sourceTokens("# pragma x /* ; */ 1'000 \"a\\\"b\" ; R\"x(\" ; )\" )x\" '\"' f() // g()\n"), tokens);
  EXPECT_EQ(sourceTokens("\"open\n x \"").front(), "x");
  EXPECT_TRUE(sourceTokens("/* open").empty());
}

TEST(SourceTokens, AreFoundInTheFunctionOfALine) {
  const std::string source =
      "auto one();\n"                                                 // 1
      "namespace a::b {\nVec3 f() {\n  auto x = one();\n"             // 2 to 4
      "  if (x) {\n    g(x);\n  }\n  return x;\n}\n"                  // to 9
      "Vec3 h() {\n  // auto\n  return { 1 };\n}\n}  // namespace\n"  // to 14
      "Vec3 k() { return 1; } Vec3 l() { auto y = 1; return y; }\n";  // 15
  const auto has = [&source](int line) { return isInFunctionOfLine(source, line, "auto"); };
  for (const int line : {1, 3, 4, 6, 8, 15}) EXPECT_TRUE(has(line)) << line;
  for (const int line : {2, 10, 11, 12, 13, 14, 16}) EXPECT_FALSE(has(line)) << line;
}

TEST(SecondLook, IsStartedByAWarningInTheStudentsLine) {
  EXPECT_TRUE(asksFor("", "spring_3d.cpp:3:4: warning: 'x' is used uninitialized [-Wuninitialized]\n"));
  EXPECT_FALSE(asksFor("", "spring_3d.cpp:3:4: warning: unused variable 'x' [-Wunused-variable]\n"));
  EXPECT_FALSE(asksFor("", "types.h:3:4: warning: 'x' is used uninitialized [-Wuninitialized]\n"));
}

TEST(SecondLook, IsStartedByWordsThatAreCut) { EXPECT_TRUE(asksFor("", "", true)); }

TEST(SecondLook, IsStartedByWhatHidesWarnings) {
  for (const char* source :
       {"#pragma GCC diagnostic ignored \"-Wuninitialized\"\n", " # pragma GCC system_header\n", "%: pragma GCC x\n",
        "#line 1 \"otra.cpp\"\n", "# 1 \"otra.cpp\"\n", "_Pragma(\"GCC diagnostic ignored\") int i;",
        "#pra\\\ngma GCC x\n", "__attribute__((optimize(\"O0\"))) int f();", "[[gnu::optimize(\"O0\")]] int f();",
        "void f() { asm(\"\"); }", "#/**/pragma clang diagnostic ignored \"-Wuninitialized\"\n"}) {
    EXPECT_TRUE(mayHideWarnings(source)) << source;
    EXPECT_TRUE(asksFor(source)) << source;
  }
  for (const char* source : {"#pragma once\n", "// #pragma GCC x\n", "#include \"spring_3d.h\"\n", "double line = 1;\n",
                             "const char* s = \"#line 1\";\n"}) {
    EXPECT_FALSE(asksFor(source)) << source;
  }
}

TEST(SecondLook, IsStartedByWhatTheCompilerDoesNotSeeThrough) {
  for (const char* source :
       {"auto rest = L0 * ones(n);", "auto f = magnitude(a) * direction(a, b);",
        "const Vec3& longer(const Vec3& a, const Vec3& b) { return a; }",
        "const Vec3& w = longer(Vec3(0, 0, 1), Vec3::Zero());", "const Eigen::Matrix<double, 3, 1>& w = longer(a, b);",
        "return [&v](double s) { return s * v; };", "return [&] { return v; };"}) {
    EXPECT_TRUE(mayOutliveTemporaries(source)) << source;
  }
  for (const char* source :
       {"auto f = [&](double s) { return s * g(v); };", "for (const auto& s : springs) F += springForce(x, s.x);",
        "const Vec3 f = magnitude(a) * direction(a, b);", "auto n = m.size();", "const Vec3& x = nodes[i].x;",
        "Vec3 f(const Vec3& a, const Vec3& b);", "bool b = (x & 3) != 0;"}) {
    EXPECT_FALSE(mayOutliveTemporaries(source)) << source;
  }
}

bool asksForOtherFill(const std::string& source, const std::string& words = "") {
  ToolRun run;
  run.succeeded = true;
  run.words = words;
  return wantsOtherFill(run, {{"spring_3d.cpp", source}});
}

TEST(OtherFill, IsAskedForByWarningsOfItsKind) {
  EXPECT_TRUE(asksForOtherFill("", "spring_3d.cpp:3:4: warning: 'x' is used uninitialized [-Wuninitialized]\n"));
  EXPECT_TRUE(asksForOtherFill("", "spring_3d.cpp:3:4: warning: 'x' may be used [-Wmaybe-uninitialized]\n"));
  EXPECT_FALSE(asksForOtherFill("", "spring_3d.cpp:3:4: warning: no return [-Wreturn-type]\n"));
}

TEST(OtherFill, IsAskedForByVariablesThatAreReadFirst) {
  for (const char* source :
       {"double f(double x) { double L; if (x > L) L = x; return L; }", "int f() { int n; return n; }",
        "int f() { int a = 1, n; return n; }", "void f() { double s[3]; g(s); }", "void f() { double* p; g(p); }",
        "Vec3 f() { Vec3 u; if (u.norm() == 0) u = Vec3::Zero(); return u; }", "void f() { double s; s += 1; }",
        "double f(bool b) { double s; if (b) s = 1; return s; }", "void f() { double s; s = s + 1; }",
        "void f() { Eigen::Matrix<double, 3, 1> u; g(u); }", "void f() { std::array<double, 3> a; g(a); }",
        "struct Sum { double total; void add(double x) { total += x; } };"}) {
    EXPECT_TRUE(mayReadUnwritten(source)) << source;
    EXPECT_TRUE(asksForOtherFill(source)) << source;
  }
  for (const char* source :
       {"double f() { double L; L = 1; return L; }", "Vec3 f() { Vec3 u; u << 1, 2, 3; return u; }",
        "void f() { Vec3 u; u.setZero(); g(u); }", "void f() { Vec6 u; u.head<3>() = g(); u.tail<3>() = h(u); }",
        "void f() { double s[3]; s[0] = 1; g(s); }", "void f() { Vec3 u; for (int i = 0; i < 3; ++i) u[i] = 1; g(u); }",
        "void f() { Mat3 M; for (int i = 0; i < 3; ++i) { for (int j : all) M(i, j) = 1; } g(M); }",
        "void f() { int i; for (i = 0; i < 3; ++i) g(i); }",
        "double f() { double a = 1, b(2), c{3}; return a + b + c; }", "double f(double x);\nVec3 g();\n",
        "struct Side { int a, b; };", "void f() { std::vector<double> z; z.push_back(1); }",
        "double f() { static double calls; return calls; }", "void f() { return g; }", "using muelle::Vec3;"}) {
    EXPECT_FALSE(mayReadUnwritten(source)) << source;
  }
}

/// It costs a second or two: of what is written well, few may be looked at twice.
TEST(SecondLook, FewRightFilesAreSuspected) {
  int files = 0;
  int suspected = 0;
  int mayBeLucky = 0;
  const fs::path checkout = build_paths::source;
  for (const fs::path& folder : {checkout / "solutions", checkout / "tests/submissions"}) {
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
      const bool isRight =
          folder.filename() == "solutions" || entry.path().string().find("/right/") != std::string::npos;
      if (!isRight || entry.path().extension() != ".cpp") continue;
      ++files;
      suspected += asksFor(readFile(entry.path())) ? 1 : 0;
      mayBeLucky += asksForOtherFill(readFile(entry.path())) ? 1 : 0;
    }
  }
  EXPECT_GT(files, 10);
  EXPECT_LE(10 * suspected, files) << suspected << " of " << files;
  EXPECT_LE(6 * mayBeLucky, files) << mayBeLucky << " of " << files;
}

TEST(SecondLook, ABuildThatFailsIsSaidAndExplained) {
  ToolRun run;
  run.words = "../submission/spring_3d.cpp:3:2: error: 'asm' operand has impossible constraints\n";
  const std::vector<StudentFile> files{{"spring_3d.cpp", ""}};
  EXPECT_EQ(
      sayNoSecondLook(run, files),
      "not looked at a second time, since it does not build with AddressSanitizer: spring_3d.cpp:3: 'asm' operand "
      "has impossible constraints\n");
  EXPECT_EQ(sayNoSecondLook({}, files), "not looked at a second time, since it does not build with AddressSanitizer\n");
}

}  // namespace
}  // namespace muelle
