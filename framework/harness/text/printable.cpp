#include "harness/text/printable.h"

#include <fmt/format.h>
#include <algorithm>

namespace muelle {

namespace {

/// Length of the well-formed UTF-8 sequence at the start of the text, and its code point; 0 when there is none.
std::size_t decode(std::string_view text, unsigned long& codePoint) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned first = byte(0);
  if (first < 0x80) return codePoint = first, 1;
  const std::size_t length = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
  if (first < 0xC2 || first > 0xF4 || text.size() < length) return 0;
  codePoint = first & (0xFFU >> (length + 1));
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xC0U) != 0x80) return 0;
    codePoint = (codePoint << 6U) | (byte(i) & 0x3FU);
  }
  const unsigned long smallest = length == 4 ? 0x10000 : length == 3 ? 0x800 : 0x80;
  const bool isSurrogate = codePoint >= 0xD800 && codePoint <= 0xDFFF;
  return codePoint < smallest || codePoint > 0x10FFFF || isSurrogate ? 0 : length;
}

/// Control characters, and the marks that hide text or turn its direction.
bool isHarmful(unsigned long c) {
  if (c == '\n' || c == '\t') return false;
  return c < 0x20 || (c >= 0x7F && c < 0xA0) || c == 0x61C || (c >= 0x200B && c <= 0x200F) ||
         (c >= 0x2028 && c <= 0x202E) || (c >= 0x2060 && c <= 0x206F) || c == 0xFEFF || c >= 0xE0000;
}

}  // namespace

std::string printable(std::string_view text) {
  std::string safe;
  while (!text.empty()) {
    unsigned long codePoint = 0;
    const std::size_t length = decode(text, codePoint);
    if (length == 0) {
      safe += fmt::format("\\x{:02x}", static_cast<unsigned char>(text[0]));
    } else if (isHarmful(codePoint)) {
      safe += codePoint < 0x100 ? fmt::format("\\x{:02x}", codePoint) : fmt::format("\\u{{{:x}}}", codePoint);
    } else {
      safe += text.substr(0, length);
    }
    text.remove_prefix(std::max<std::size_t>(length, 1));
  }
  return safe;
}

std::string cutText(std::string_view text, int lines, std::size_t bytes) {
  std::size_t end = 0;
  for (int line = 0; line < lines && end < text.size(); ++line) {
    const std::size_t newline = text.find('\n', end);
    end = newline == std::string_view::npos ? text.size() : newline + 1;
  }
  end = std::min(end, bytes);
  // Not in the middle of a character.
  while (end < text.size() && end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80) --end;
  std::string kept(text.substr(0, end));
  if (end == text.size()) return kept;
  if (!kept.empty() && kept.back() != '\n') kept += '\n';
  return kept + fmt::format("... ({} more bytes)\n", text.size() - end);
}

std::string indented(std::string_view text, std::string_view prefix) {
  std::string result;
  while (!text.empty()) {
    const std::size_t newline = std::min(text.find('\n'), text.size() - 1);
    result += prefix;
    result += text.substr(0, newline + 1);
    text.remove_prefix(newline + 1);
  }
  return result;
}

}  // namespace muelle
