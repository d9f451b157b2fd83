#include "base/text/fnv1a.h"

#include <gtest/gtest.h>

namespace muelle {
namespace {

/// The vectors of its authors' page (Fowler, Noll, Vo).
TEST(Fnv1a, GivesItsPublishedValues) {
  EXPECT_EQ(fnv1a(""), 0xcbf29ce484222325U);
  EXPECT_EQ(fnv1a("a"), 0xaf63dc4c8601ec8cU);
  EXPECT_EQ(fnv1a("foobar"), 0x85944171f73967e8U);
}

TEST(Fnv1a, GoesOnFromWhatStandsBefore) { EXPECT_EQ(fnv1a("bar", fnv1a("foo")), fnv1a("foobar")); }

}  // namespace
}  // namespace muelle
