#pragma once
#include <string>
#include <vector>

namespace muelle {

/// Texts that act when they are not shown as text: markup, scripts, terminal escapes, formulas, bytes that are no
/// UTF-8.
inline const std::vector<std::string>& hostileTexts() {
  static const std::vector<std::string> texts{
      "<script>alert(1)</script>",
      "\"><img src=x onerror=alert(1)>",
      "'><svg/onload=alert(1)>",
      "</pre></div><iframe src=\"http://example.com\">",
      "]]><!--<?xml?>&lol;&#0;",
      "\x1b[2J\x1b]0;title\x07 \x9b"
      "31m \xc2\x9b"
      "31m",
      "=cmd|' /C calc'!A0",
      "+1+1",
      "@SUM(A1)",
      "set terminal png; system \"rm -rf /\"",
      std::string("nul\0inside", 10),
      "bad \xff\xfe \xc3( \xed\xa0\x80 \xf4\x90\x80\x80 \xc0\xaf \xe2\x82",
      "\u202egnp.exe \u2066 \u200f \u061c \ufeff \u200b \u2028 \u2029 \U000e0041 \uffff",
      "one\rtwo\r\nthree\vfour\ffive\tsix",
      "[       OK ] HookeForce.All (0 ms)\n[  PASSED  ] 99 tests.",
      std::string(100'000, 'A'),
      "Z\u0300\u0301\u0302\u0303 日本語 🙂",
  };
  return texts;
}

}  // namespace muelle
