/// \file
/// The words of mold and of GNU ld for the same mistakes.

#include "course/check/diagnostics.h"
#include "course/check/missing_functions.h"

#include <gtest/gtest.h>

namespace muelle {
namespace {

const std::string springContract =
    "/// Force on a: springForce(xa, xb, k, L0)\n"
    "Vec3 springForce(const Vec3& xa, const Vec3& xb,\n"
    "                 double k, double L0);\n"
    "double lumpedMass(double M, int n);\n";

std::string explain(const std::string& linkerText, const std::string& source) {
  return explainLinkErrors(linkerText, {{"spring.cpp", source}}, springContract, "spring.h");
}

const std::string mold =
    "mold: error: undefined symbol: springForce(Eigen::Matrix<double, 3, 1, 0, 3, 1> const&, double)\n"
    ">>> referenced by public_test.cpp\n"
    "collect2: error: ld returned 1 exit status\n";
const std::string gnu =
    "/usr/bin/ld: t.o: in function `Twice':\n"
    "t.cpp:(.text+0x43): undefined reference to `springForce(Eigen::Matrix<double, 3, 1, 0, 3, 1> const&, double)'\n"
    "/usr/bin/ld: t.cpp:(.text+0x99): undefined reference to `springForce(Eigen::Matrix<double, 3, 1, 0, 3, 1> const&, "
    "double)'\ncollect2: error: ld returned 1 exit status\n";
const std::string declaration =
    "spring.h declares this function, and spring.cpp does not define it:\n"
    "      Vec3 springForce(const Vec3& xa, const Vec3& xb, double k, double L0)\n";

TEST(LinkErrors, AMissingFunctionIsQuotedFromTheContract) {
  EXPECT_EQ(explain(mold, "double lumpedMass(double M, int n) { return M / n; }\n"), declaration);
  EXPECT_EQ(explain(gnu, "double lumpedMass(double M, int n) { return M / n; }\n"), declaration);
}

TEST(LinkErrors, AMisspeltFunctionIsFound) {
  EXPECT_EQ(explain(mold, "\nVec3 springForse(const Vec3& xa) { return xa; }\n"),
            declaration + "      = spring.cpp:2 is called springForse: is that a slip?\n");
}

TEST(LinkErrors, AnotherSignatureIsFound) {
  EXPECT_NE(
      explain(gnu, "Vec3 springForce(Vec3 xa) { return xa; }\n").find("spring.cpp:1 has the name, but other argument"),
      std::string::npos);
}

TEST(LinkErrors, AnInlineFunctionIsNoneForOthers) {
  EXPECT_EQ(explain(mold, "\ninline Vec3 springForce(const Vec3& xa) { return xa; }\n"),
            declaration + "      = spring.cpp:2 is inline: nothing outside the file can call it; remove inline\n");
}

TEST(LinkErrors, AStaticFunctionIsNoneForOthers) {
  EXPECT_EQ(explain(mold, "\nstatic Vec3 springForce(const Vec3& xa) { return xa; }\n"),
            declaration + "      = spring.cpp:2 is static: nothing outside the file can call it; remove static\n");
}

TEST(LinkErrors, OfManyTheFirstFewAreShown) {
  std::string words;
  for (int i = 0; i < 400; ++i) words += "mold: error: undefined symbol: helper" + std::to_string(i) + "(double)\n";
  EXPECT_EQ(explain(words, ""),
            "spring.cpp calls helper0, which is written nowhere\nspring.cpp calls helper1, which is written nowhere\n"
            "spring.cpp calls helper2, which is written nowhere\nand 397 more that are missing\n");
}

TEST(LinkErrors, AHelperThatIsWrittenNowhereIsNamed) {
  EXPECT_EQ(explain("mold: error: undefined symbol: stretch(double)\n", ""),
            "spring.cpp calls stretch, which is written nowhere\n");
}

TEST(LinkErrors, AFunctionOfAnotherHeaderOfEigenIsNamed) {
  const std::string vector = "Eigen::Matrix<double, 3, 1, 0, 3, 1>";
  const std::string base = "Eigen::MatrixBase<" + vector + " >::";
  const std::string words = "mold: error: undefined symbol: " + base + "cross_product_return_type<" + vector +
                            " >::type " + base + "cross<" + vector + " >(" + base + " const&) const\n";
  EXPECT_EQ(explain(words, ""),
            "spring.cpp uses Eigen's cross(), which stands in another header\n"
            "      = add  #include <Eigen/Dense>  below the include of spring.h\n");
}

TEST(LinkErrors, MainIsForTheCheckingProgram) {
  const std::string message = "your file defines main: leave it out\n";
  EXPECT_EQ(explain("mold: error: duplicate symbol: a.o: b.o: main\n", ""), message);
  EXPECT_EQ(
      explain(
          "ld: a.o: in function `main':\na.cpp:(.text+0x0): multiple definition of `main'; b.o: first defined here\n",
          ""),
      message);
}

TEST(LinkErrors, OtherWordsAreShownCut) {
  EXPECT_EQ(explain("ld: cannot find -lfoo\n", ""), "ld: cannot find -lfoo\n");
}

TEST(MissingFunctions, AreThoseOfTheContractWhereNothingElseIsWrong) {
  EXPECT_EQ(missingFunctions(mold, springContract), std::vector<std::string>{"springForce"});
  EXPECT_EQ(missingFunctions(gnu, springContract), std::vector<std::string>{"springForce"});
  EXPECT_TRUE(missingFunctions(mold + "mold: error: undefined symbol: helper(double)\n", springContract).empty());
  EXPECT_TRUE(missingFunctions(mold + "mold: error: duplicate symbol: a.o: b.o: main\n", springContract).empty());
}

TEST(MissingFunctions, AreDefinedWithWhatIsToBeSaidOfThem) {
  const std::vector<StudentFile> students{{"spring.cpp", "inline Vec3 springForce(Vec3 xa) { return xa; }\n"}};
  const std::string source = missingSource({"springForce"}, students, springContract, "spring.h");
  EXPECT_NE(source.find("Vec3 springForce(const Vec3& xa, const Vec3& xb, double k, double L0) {"), std::string::npos)
      << source;
  EXPECT_NE(source.find("springForce is missing: spring.cpp:1 is inline"), std::string::npos) << source;
}

TEST(MissingFunctions, MayBeStaticOnes) {
  const std::vector<StudentFile> students{{"spring.cpp", "static double f() { return 1; }\n}\n"}};
  const std::string isStatic =
      "spring.cpp:1:15: error: 'double f()' was declared 'extern' and later 'static' [-fpermissive]\n";
  EXPECT_EQ(staticFunctions(isStatic, students), std::vector<std::string>{"f"});
  EXPECT_TRUE(staticFunctions(isStatic + "spring.cpp:2:1: error: expected ';'\n", students).empty());
  EXPECT_TRUE(staticFunctions("", students).empty());
}

}  // namespace
}  // namespace muelle
