#include "base/text/csv.h"

#include <gtest/gtest.h>

namespace muelle {
namespace {

TEST(CsvField, DisarmsFormulas) {
  EXPECT_EQ(untrustedCsvField("=cmd|' /C calc'!A0"), "\"'=cmd|' /C calc'!A0\"");
  for (const char* text : {"=1", "+1", "-1", "@x", "  =1", "\t=1"})
    EXPECT_EQ(untrustedCsvField(text).substr(0, 2), "\"'") << text;
}

TEST(CsvField, QuotesAndStaysOnItsLine) {
  EXPECT_EQ(untrustedCsvField("a \"b\", c"), "\"a \"\"b\"\", c\"");
  EXPECT_EQ(untrustedCsvField("a\nb"), "\"a\\nb\"");
  EXPECT_EQ(untrustedCsvField(""), "\"\"");
}

TEST(CsvField, IsQuotedOnlyWhenItMustBe) {
  EXPECT_EQ(csvField("-1.5"), "-1.5");
  EXPECT_EQ(csvField("a, \"b\""), "\"a, \"\"b\"\"\"");
}

}  // namespace
}  // namespace muelle
