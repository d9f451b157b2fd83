#include "grader/text/printable.h"

#include "grader/text/utf8.h"

#include <fmt/format.h>

namespace muelle::grader {

namespace {

/// Characters that are invisible, reorder their neighbours or are none at all.
bool isTreacherous(char32_t c) {
  const auto in = [c](char32_t first, char32_t last) { return first <= c && c <= last; };
  return in(0x00, 0x1F) || in(0x7F, 0x9F) ||                          // control characters
         c == 0x00AD || c == 0x034F || c == 0x061C || c == 0x180E ||  // soft hyphen, joiners, Arabic letter mark
         in(0x115F, 0x1160) || c == 0x3164 || c == 0xFFA0 ||          // Hangul fillers
         in(0x17B4, 0x17B5) || in(0x200B, 0x200F) || in(0x2028, 0x202E) || in(0x2060, 0x206F) || c == 0xFEFF ||
         in(0xFFF0, 0xFFFB) ||  // byte-order mark, interlinear annotation
         in(0xE000, 0xF8FF) || in(0xFDD0, 0xFDEF) || (c & 0xFFFE) == 0xFFFE ||  // private use, no characters
         in(0x1BCA0, 0x1BCA3) || in(0x1D173, 0x1D17A) || in(0xE0000, 0xE00FF) || c >= 0xE01F0;
}

std::string spelled(const CodePoint& point) {
  const auto value = static_cast<unsigned>(point.value);
  if (point.value == '\n') return "\\n";
  if (point.value == '\r') return "\\r";
  return !point.valid || value < 0x80 ? fmt::format("\\x{:02x}", value) : fmt::format("\\u{{{:x}}}", value);
}

std::string printable(std::string_view text, bool severalLines) {
  std::string out;
  out.reserve(text.size());
  while (!text.empty()) {
    const CodePoint point = decodeUtf8(text);
    const bool endsLine = severalLines && (text.front() == '\n' || text.starts_with("\r\n"));
    if (endsLine) {
      out += '\n';
      text.remove_prefix(text.front() == '\r' ? 2 : 1);
      continue;
    }
    if (point.value == '\t') {
      out += severalLines ? "    " : " ";
    } else if (!point.valid || isTreacherous(point.value)) {
      out += spelled(point);
    } else {
      out += text.substr(0, point.length);
    }
    text.remove_prefix(point.length);
  }
  return out;
}

}  // namespace

std::string printableLine(std::string_view text) { return printable(text, false); }
std::string printableText(std::string_view text) { return printable(text, true); }

std::string cut(const std::string& text, std::size_t bytes) {
  if (text.size() <= bytes) return text;
  std::size_t end = bytes;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0u) == 0x80u) --end;
  return text.substr(0, end) + "...";
}

}  // namespace muelle::grader
