#include "base/text/utf8.h"

#include <utf8proc.h>

namespace muelle {

CodePoint decodeUtf8(std::string_view text) {
  utf8proc_int32_t value = 0;
  const auto* bytes = reinterpret_cast<const utf8proc_uint8_t*>(text.data());
  const utf8proc_ssize_t length = utf8proc_iterate(bytes, static_cast<utf8proc_ssize_t>(text.size()), &value);
  if (length <= 0) return {static_cast<unsigned char>(text.front()), 1, false};
  return {static_cast<char32_t>(value), static_cast<std::size_t>(length), true};
}

bool isTreacherous(char32_t codePoint) {
  switch (utf8proc_category(static_cast<utf8proc_int32_t>(codePoint))) {
    case UTF8PROC_CATEGORY_CC:
    case UTF8PROC_CATEGORY_CF:
    case UTF8PROC_CATEGORY_CS:
    case UTF8PROC_CATEGORY_CO:
    case UTF8PROC_CATEGORY_CN:
    case UTF8PROC_CATEGORY_ZL:
    case UTF8PROC_CATEGORY_ZP:
      return true;
    default:
      break;
  }
  // Letters and marks by category, yet nothing to be seen: Hangul and Khmer fillers, the grapheme joiner.
  const auto in = [codePoint](char32_t first, char32_t last) { return first <= codePoint && codePoint <= last; };
  return in(0x115F, 0x1160) || in(0x17B4, 0x17B5) || codePoint == 0x034F || codePoint == 0x3164 || codePoint == 0xFFA0;
}

int columns(char32_t codePoint) {
  const int width = utf8proc_charwidth(static_cast<utf8proc_int32_t>(codePoint));
  return width < 0 ? 0 : width;
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

}  // namespace muelle
