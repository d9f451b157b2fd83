#include "course/check/filled_flags.h"

#include <gtest/gtest.h>

namespace muelle {
namespace {

TEST(FilledFlags, OfAFunctionGetAValueThatIsNone) {
  EXPECT_EQ(
      withFilledFlags("int f() {\n  bool a; // here\n  if (x) { bool b, c;\n }\n}\n"),
      "int f() {\n  bool a; __builtin_memset(&a, 0xfe, sizeof a); // here\n  if (x) { bool b, c; __builtin_memset(&b, "
      "0xfe, sizeof b); __builtin_memset(&c, 0xfe, sizeof c);\n }\n}\n");
}

TEST(FilledNumbers, OfAFunctionAreLarge) {
  EXPECT_EQ(withFilledNumbers("double f() { double L; bool b; double k = 2; return L; }"),
            "double f() { double L; __builtin_memset(&L, 0x7f, sizeof L); bool b; double k = 2; return L; }");
}

TEST(FilledFlags, OthersStayAsTheyAre) {
  for (const char* source :
       {"bool global;\n", "namespace a { bool b; }\n", "struct S { double d; bool b; };\n",
        "int f() { struct S { int i; bool b; } s; return s.i; }\n", "int f() { bool b = true; bool c{}; return b; }\n",
        "int f() { static bool b; return b; }\n", "bool f();\nint g(bool b);\n", "int f() { // bool b;\n }\n", "bool",
        "{ bool"}) {
    EXPECT_EQ(withFilledFlags(source), source);
  }
}

}  // namespace
}  // namespace muelle
