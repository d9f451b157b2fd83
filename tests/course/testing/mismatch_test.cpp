#include "course/testing/mismatch_text.h"

#include <gtest/gtest.h>
#include <bit>
#include <cstdint>
#include <limits>

namespace muelle {
namespace {

std::uint64_t bits(double number) { return std::bit_cast<std::uint64_t>(number); }

Mismatch sample() {
  Mismatch m;
  m.label = "height at t = 0.35 s";
  m.expression = "f(x)";
  m.ofCall = true;
  m.call = "f(0.1, \"a\\n\")";
  m.row = 2;
  m.col = 1;
  m.rows = 3;
  m.cols = 4;
  m.gotRows = 5;
  m.gotCols = 6;
  m.got = std::bit_cast<double>(0x7ff8000000000123ULL);
  m.expected = 0.1;
  m.tolerance = 1e-300;
  m.unit = "m/s";
  m.says = "a sentence";
  return m;
}

TEST(Sentence, OfAStatementIsTheStatement) {
  Mismatch m;
  m.says = "springForce threw an exception: not yet";
  m.got = 3.0;
  EXPECT_EQ(sentence(m), "springForce threw an exception: not yet");
}

TEST(Sentence, WithoutANameBeginsWithThePlace) {
  Mismatch m;
  m.row = 2;
  m.col = 0;
  m.rows = m.gotRows = 3;
  m.got = 1.5;
  m.expected = 1.0;
  m.tolerance = 1e-9;
  EXPECT_EQ(sentence(m), "component 2: got 1.5, expected 1 (difference 0.5, tolerance 1e-09)");
  m.row = m.col = -1;
  EXPECT_EQ(sentence(m), "got 1.5, expected 1 (difference 0.5, tolerance 1e-09)");
}

TEST(Sentence, OfANameThatLooksLikeOneStaysWhole) {
  Mismatch m;
  m.label = "f(x): got 3, expected 4";
  m.got = 1.0;
  EXPECT_EQ(wordsOf(m).what, "f(x): got 3, expected 4");
  EXPECT_EQ(wordsOf(m).got, "1");
}

TEST(ExactText, ReadsBackWithEveryBit) {
  using limits = std::numeric_limits<double>;
  for (const double number :
       {0.0, -0.0, 0.1, 1.0 / 3.0, -1e308, limits::denorm_min(), limits::max(), limits::epsilon(), limits::infinity(),
        -limits::infinity(), limits::quiet_NaN(), -limits::quiet_NaN(), std::bit_cast<double>(0x7ff4dead0000beefULL),
        std::bit_cast<double>(0xfff8000000000001ULL)}) {
    const std::optional<double> back = exactNumber(exactText(number));
    ASSERT_TRUE(back.has_value()) << exactText(number);
    EXPECT_EQ(bits(*back), bits(number)) << exactText(number);
  }
}

TEST(ExactText, RefusesEverythingElse) {
  for (const char* text : {"", " 1", "1 ", "nan", "inf", "0x10", "1.2.3", "1e999", "bits:", "bits:7ff80000000000000",
                           "bits:7ff800000000000g", "bits: 7ff800000000000"})
    EXPECT_FALSE(exactNumber(text)) << text;
}

TEST(MismatchText, ReadsBackWhole) {
  const Mismatch m = sample();
  const std::optional<Mismatch> back = readMismatch(mismatchText(m));
  ASSERT_TRUE(back.has_value());
  EXPECT_EQ(back->label, m.label);
  EXPECT_EQ(back->call, m.call);
  EXPECT_EQ(back->row, 2);
  EXPECT_EQ(back->gotCols, 6);
  EXPECT_EQ(bits(back->got), bits(m.got));
  EXPECT_EQ(back->tolerance, 1e-300);
  EXPECT_EQ(back->says, "a sentence");
  EXPECT_EQ(mismatchText(*back), mismatchText(m));
}

TEST(MismatchText, IsRefusedWhenAFieldIsMissingOrTooMany) {
  const std::string text = mismatchText(sample());
  EXPECT_FALSE(readMismatch(""));
  EXPECT_FALSE(readMismatch(text + '\x1f'));
  EXPECT_FALSE(readMismatch(text.substr(text.find('\x1f') + 1)));
  Mismatch treacherous = sample();
  treacherous.label =
      "a\x1f"
      "b";
  EXPECT_EQ(readMismatch(mismatchText(treacherous))->label, "a b");
}

}  // namespace
}  // namespace muelle
