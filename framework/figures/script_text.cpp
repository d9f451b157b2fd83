#include "figures/script_text.h"

#include <string_view>

namespace muelle::figures {

namespace {

void replaceAll(std::string& text, std::string_view what, std::string_view with) {
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + with.size())) {
    text.replace(at, what.size(), with);
  }
}

const char* wordOf(Side side) {
  switch (side) {
    case Side::Left:
      return "left";
    case Side::Centre:
      return "center";
    case Side::Right:
      break;
  }
  return "right";
}

}  // namespace

std::string quoted(std::string text) {
  replaceAll(text, "'", "''");
  return '\'' + text + '\'';
}

std::string quotedName(std::string text) {
  replaceAll(text, "%", "%%");
  return quoted(std::move(text));
}

void ScriptText::putLabel(const std::string& text, const Label& place, const std::string& fontSize) {
  if (text.empty()) return;
  const std::string font = fontSize.empty() ? "" : fmt::format(" font ',{}'", fontSize);
  put("set label {} at screen {},{} {} noenhanced{} textcolor rgb '#111111'", quoted(text), x(place.x), y(place.y),
      wordOf(place.side), font);
}

}  // namespace muelle::figures
