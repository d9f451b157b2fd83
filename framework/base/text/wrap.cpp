#include "base/text/wrap.h"

#include "base/text/utf8.h"

#include <algorithm>

namespace muelle {

namespace {

/// The longest piece of `line` that fits into `width` columns, at least one character; ends at a space when it can.
std::string takeColumns(std::string& line, int width) {
  std::size_t end = 0, space = 0;
  int used = 0;
  while (end < line.size()) {
    const CodePoint point = decodeUtf8(std::string_view(line).substr(end));
    used += columns(point.value);
    if (used > width && end > 0) break;
    if (point.value == ' ') space = end;
    end += point.length;
  }
  if (end < line.size() && space > 0 && line[end] != ' ') end = space;
  std::string piece = line.substr(0, end);
  line.erase(0, line.find_first_not_of(' ', end));
  return piece;
}

/// Bytes of the longest front that fits.
std::size_t bytesWithin(std::string_view line, int width) {
  std::size_t end = 0;
  for (int used = 0; end < line.size();) {
    const CodePoint point = decodeUtf8(line.substr(end));
    used += columns(point.value);
    if (used > width) break;
    end += point.length;
  }
  return end;
}

}  // namespace

std::vector<std::string> wrap(std::string line, int width) {
  std::vector<std::string> pieces;
  while (!line.empty()) pieces.push_back(takeColumns(line, std::max(width, 1)));
  return pieces;
}

std::string fitted(std::string_view line, int width) {
  std::string text(line);
  if (columns(line) > width) text = std::string(line.substr(0, bytesWithin(line, width - 1))) + "…";
  // A wide character that did not fit leaves a column free.
  return text + std::string(static_cast<std::size_t>(std::max(width - columns(text), 0)), ' ');
}

}  // namespace muelle
