#include "course/check/report_line.h"

#include <gtest/gtest.h>

namespace muelle {
namespace {

TEST(ReportLine, CarriesAnyText) {
  const std::string text = "two\nlines\tand a \\n that is none\\";
  const auto entries = readReport(reportLine("failure", text) + reportLine("done", ""));
  ASSERT_EQ(entries.size(), 2U);
  EXPECT_EQ(entries[0], std::pair(std::string("failure"), text));
  EXPECT_EQ(entries[1], std::pair(std::string("done"), std::string()));
}

TEST(ReportLine, IgnoresAHalfLine) { EXPECT_EQ(readReport("test\tA.B\ndo").size(), 1U); }

}  // namespace
}  // namespace muelle
