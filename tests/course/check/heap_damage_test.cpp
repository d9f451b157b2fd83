#include "course/check/heap_damage.h"

#include <gtest/gtest.h>

namespace muelle {
namespace {

TEST(HeapDamage, IsSaidInTheLibrarysLastWords) {
  EXPECT_EQ(
      heapDamage("a student's words\nfree(): invalid next size (fast)\n"),
      "damaged the heap: something was written beyond the end of an array or a vector, or given back twice (free(): "
      "invalid next size (fast))");
  EXPECT_NE(heapDamage("double free or corruption (out)"), "");
  EXPECT_EQ(heapDamage("free(): invalid pointer\nterminate called\n"), "");
  EXPECT_EQ(heapDamage(""), "");
}

}  // namespace
}  // namespace muelle
