#include "base/text/printable.h"

#include "base/text/utf8.h"

#include <fmt/format.h>
#include <algorithm>

namespace muelle {

namespace {

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
