#include "base/text/escape.h"

#include "base/text/printable.h"

namespace muelle {

namespace {

std::string escapeMarkup(const std::string& text) {
  std::string out;
  out.reserve(text.size());
  for (const char c : text) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      case '\'':
        out += "&#39;";
        break;
      default:
        out += c;
    }
  }
  return out;
}

bool looksLikeFormula(const std::string& text) {
  const std::size_t first = text.find_first_not_of(' ');
  return first != std::string::npos && std::string_view("=+-@").find(text[first]) != std::string_view::npos;
}

std::string inQuotes(std::string_view text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"') out += '"';
    out += c;
  }
  return out + '"';
}

}  // namespace

std::string escapeHtml(std::string_view text) { return escapeMarkup(printableText(text)); }
std::string escapeXml(std::string_view text) { return escapeMarkup(printableText(text)); }
std::string escapeXmlAttribute(std::string_view text) { return escapeMarkup(printableLine(text)); }

std::string csvField(std::string_view text) {
  return text.find_first_of(",\"\r\n") == std::string_view::npos ? std::string(text) : inQuotes(text);
}

std::string untrustedCsvField(std::string_view text) {
  const std::string line = printableLine(text);
  return inQuotes(looksLikeFormula(line) ? "'" + line : line);
}

std::string base64(std::string_view bytes) {
  constexpr std::string_view alphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  out.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const auto byte = [&](std::size_t k) {
      return i + k < bytes.size() ? static_cast<unsigned>(static_cast<unsigned char>(bytes[i + k])) : 0u;
    };
    const unsigned group = byte(0) << 16 | byte(1) << 8 | byte(2);
    out += alphabet[group >> 18];
    out += alphabet[group >> 12 & 63u];
    out += i + 1 < bytes.size() ? alphabet[group >> 6 & 63u] : '=';
    out += i + 2 < bytes.size() ? alphabet[group & 63u] : '=';
  }
  return out;
}

}  // namespace muelle
