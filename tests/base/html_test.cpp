#include "base/text/html.h"

#include "support/hostile_texts.h"

#include <gtest/gtest.h>

namespace muelle {
namespace {

TEST(EscapeHtml, LeavesNothingThatMarksUp) {
  EXPECT_EQ(escapeHtml("<a href=\"x\" b='y'>&amp;"), "&lt;a href=&quot;x&quot; b=&#39;y&#39;&gt;&amp;amp;");
  for (const std::string& text : hostileTexts()) EXPECT_EQ(escapeHtml(text).find_first_of("<>\"'"), std::string::npos);
}

}  // namespace
}  // namespace muelle
