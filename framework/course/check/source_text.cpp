#include "course/check/source_text.h"

#include <fmt/format.h>
#include <algorithm>
#include <cstddef>
#include <optional>
#include <string_view>

namespace muelle {

namespace {

constexpr std::string_view utf8Mark = "\xef\xbb\xbf";
constexpr std::string_view littleEndianMark = "\xff\xfe";
constexpr std::string_view bigEndianMark = "\xfe\xff";

void appendUtf8(std::string& text, char32_t c) {
  const auto continuation = [&](int shift) { text += static_cast<char>(0x80 | ((c >> shift) & 0x3f)); };
  if (c < 0x80) {
    text += static_cast<char>(c);
  } else if (c < 0x800) {
    text += static_cast<char>(0xc0 | (c >> 6));
    continuation(0);
  } else if (c < 0x10000) {
    text += static_cast<char>(0xe0 | (c >> 12));
    continuation(6);
    continuation(0);
  } else {
    text += static_cast<char>(0xf0 | (c >> 18));
    continuation(12);
    continuation(6);
    continuation(0);
  }
}

/// nullopt when the bytes are no well-formed UTF-16: an odd number of them, or half a surrogate pair.
std::optional<std::string> fromUtf16(std::string_view bytes, bool bigEndian) {
  if (bytes.size() % 2 != 0) return std::nullopt;
  const auto unit = [&](std::size_t i) {
    const auto low = static_cast<unsigned char>(bytes[i + (bigEndian ? 1 : 0)]);
    const auto high = static_cast<unsigned char>(bytes[i + (bigEndian ? 0 : 1)]);
    return static_cast<char32_t>(high << 8 | low);
  };
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 2) {
    char32_t c = unit(i);
    if (c >= 0xdc00 && c < 0xe000) return std::nullopt;
    if (c >= 0xd800 && c < 0xdc00) {
      i += 2;
      if (i >= bytes.size()) return std::nullopt;
      const char32_t low = unit(i);
      if (low < 0xdc00 || low >= 0xe000) return std::nullopt;
      c = 0x10000 + ((c - 0xd800) << 10) + (low - 0xdc00);
    }
    appendUtf8(text, c);
  }
  return text;
}

void add(std::string& note, std::string_view what) { note += fmt::format("{}{}", note.empty() ? "" : "; ", what); }

}  // namespace

SourceText readSource(std::string bytes) {
  SourceText source;
  const bool littleEndian = bytes.starts_with(littleEndianMark);
  if (littleEndian || bytes.starts_with(bigEndianMark)) {
    std::optional<std::string> text = fromUtf16(std::string_view(bytes).substr(2), !littleEndian);
    if (!text) return {"", "", "is no text: it begins as UTF-16 and is none; save it as UTF-8"};
    source.text = std::move(*text);
    add(source.note, "converted from UTF-16");
  } else {
    source.text = std::move(bytes);
  }
  if (source.text.starts_with(utf8Mark)) source.text.erase(0, utf8Mark.size());
  if (const std::size_t nul = source.text.find('\0'); nul != std::string::npos)
    return {"", "", fmt::format("is no text: byte {} is NUL; save it as UTF-8", nul + 1)};
  if (source.text.find('\r') != std::string::npos && source.text.find('\n') == std::string::npos) {
    std::replace(source.text.begin(), source.text.end(), '\r', '\n');
    add(source.note, "its line ends, carriage returns alone, made line feeds");
  }
  return source;
}

}  // namespace muelle
