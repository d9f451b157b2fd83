#include "grader/text/utf8.h"

#include <algorithm>
#include <array>

namespace muelle::grader {

namespace {

struct Range {
  char32_t first, last;
};

constexpr std::array wide{Range{0x1100, 0x115F},   Range{0x231A, 0x231B},   Range{0x2329, 0x232A},
                          Range{0x2E80, 0x303E},   Range{0x3041, 0xA4CF},   Range{0xA960, 0xA97F},
                          Range{0xAC00, 0xD7A3},   Range{0xF900, 0xFAFF},   Range{0xFE10, 0xFE19},
                          Range{0xFE30, 0xFE6F},   Range{0xFF00, 0xFF60},   Range{0xFFE0, 0xFFE6},
                          Range{0x16FE0, 0x18CFF}, Range{0x1AFF0, 0x1B2FF}, Range{0x1F300, 0x1F64F},
                          Range{0x1F680, 0x1F6FF}, Range{0x1F900, 0x1FAFF}, Range{0x20000, 0x3FFFD}};

constexpr std::array combining{Range{0x0300, 0x036F}, Range{0x0483, 0x0489},  Range{0x0591, 0x05BD},
                               Range{0x0610, 0x061A}, Range{0x064B, 0x065F},  Range{0x1AB0, 0x1AFF},
                               Range{0x1DC0, 0x1DFF}, Range{0x20D0, 0x20FF},  Range{0xFE00, 0xFE0F},
                               Range{0xFE20, 0xFE2F}, Range{0xE0100, 0xE01EF}};

template <std::size_t N>
bool contains(const std::array<Range, N>& ranges, char32_t c) {
  return std::any_of(ranges.begin(), ranges.end(), [c](const Range& r) { return r.first <= c && c <= r.last; });
}

/// Length and payload of a leading byte; length 0 when it leads nothing.
CodePoint lead(unsigned char byte) {
  if (byte < 0x80) return {byte, 1, true};
  if (byte >= 0xC2 && byte <= 0xDF) return {byte & 0x1Fu, 2, true};
  if (byte >= 0xE0 && byte <= 0xEF) return {byte & 0x0Fu, 3, true};
  if (byte >= 0xF0 && byte <= 0xF4) return {byte & 0x07u, 4, true};
  return {byte, 1, false};
}

bool isScalar(char32_t value, std::size_t length) {
  if (length == 3) return value >= 0x800 && !(value >= 0xD800 && value <= 0xDFFF);
  if (length == 4) return value >= 0x10000 && value <= 0x10FFFF;
  return true;
}

}  // namespace

CodePoint decodeUtf8(std::string_view text) {
  const auto first = static_cast<unsigned char>(text.front());
  const CodePoint invalid{first, 1, false};
  CodePoint point = lead(first);
  if (!point.valid || point.length > text.size()) return invalid;
  for (std::size_t i = 1; i < point.length; ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    if ((byte & 0xC0u) != 0x80u) return invalid;
    point.value = (point.value << 6) | (byte & 0x3Fu);
  }
  return isScalar(point.value, point.length) ? point : invalid;
}

int columns(char32_t codePoint) {
  if (contains(combining, codePoint)) return 0;
  return contains(wide, codePoint) ? 2 : 1;
}

int columns(std::string_view line) {
  int total = 0;
  while (!line.empty()) {
    const CodePoint point = decodeUtf8(line);
    total += columns(point.value);
    line.remove_prefix(point.length);
  }
  return total;
}

}  // namespace muelle::grader
