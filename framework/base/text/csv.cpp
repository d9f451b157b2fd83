#include "base/text/csv.h"

#include "base/text/printable.h"

namespace muelle {

namespace {

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

std::string csvField(std::string_view text) {
  return text.find_first_of(",\"\r\n") == std::string_view::npos ? std::string(text) : inQuotes(text);
}

std::string untrustedCsvField(std::string_view text) {
  const std::string line = printableLine(text);
  return inQuotes(looksLikeFormula(line) ? "'" + line : line);
}

}  // namespace muelle
