#include "well_formed.h"

#include "base/text/utf8.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace muelle::grader {

namespace {

bool isName(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-' || c == '.'; }

std::string takeName(std::string_view& text) {
  std::size_t end = 0;
  while (end < text.size() && isName(text[end])) ++end;
  const std::string name(text.substr(0, end));
  text.remove_prefix(end);
  return name;
}

void skipSpace(std::string_view& text) {
  while (!text.empty() && (text.front() == ' ' || text.front() == '\n')) text.remove_prefix(1);
}

std::string characterFault(std::string_view text) {
  while (!text.empty()) {
    const CodePoint point = decodeUtf8(text);
    const char32_t c = point.value;
    const bool allowed = c == '\n' || c == '\t' || (c >= 0x20 && c != 0xFFFE && c != 0xFFFF);
    if (!point.valid || !allowed) return "a byte or character that XML does not allow";
    text.remove_prefix(point.length);
  }
  return "";
}

std::string referenceFault(std::string_view text) {
  static constexpr std::array<std::string_view, 5> known{"&amp;", "&lt;", "&gt;", "&quot;", "&#39;"};
  for (std::size_t i = text.find('&'); i != std::string_view::npos; i = text.find('&', i + 1)) {
    const bool fine = std::any_of(known.begin(), known.end(), [&](auto r) { return text.substr(i).starts_with(r); });
    if (!fine) return "a bare &";
  }
  return text.find('<') == std::string_view::npos ? "" : "a bare <";
}

/// Reads what follows a tag's name up to its ">"; returns the fault.
std::string takeAttributes(std::string_view& text, std::vector<std::string>& names, bool& closed) {
  for (;;) {
    skipSpace(text);
    if (text.starts_with("/>") || text.starts_with(">")) {
      closed = text.front() == '/';
      text.remove_prefix(closed ? 2 : 1);
      return "";
    }
    const std::string name = takeName(text);
    if (name.empty() || !text.starts_with("=\"")) return "an attribute that is not name=\"value\"";
    const std::size_t end = text.find('"', 2);
    if (end == std::string_view::npos) return "an open attribute";
    const std::string fault = referenceFault(text.substr(2, end - 2));
    if (!fault.empty()) return fault + " in an attribute";
    if (std::find(names.begin(), names.end(), name) != names.end()) return "an attribute twice";
    names.push_back(name);
    text.remove_prefix(end + 1);
  }
}

}  // namespace

std::string xmlFault(std::string_view text) {
  constexpr std::string_view declaration = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
  if (!text.starts_with(declaration)) return "no declaration";
  text.remove_prefix(declaration.size());
  if (const std::string fault = characterFault(text); !fault.empty()) return fault;
  std::vector<std::string> open;
  int roots = 0;
  while (!text.empty()) {
    const std::size_t tag = std::min(text.find('<'), text.size());
    const std::string_view between = text.substr(0, tag);
    if (const std::string fault = referenceFault(between); !fault.empty()) return fault;
    if (open.empty() && between.find_first_not_of('\n') != std::string_view::npos) return "text outside the root";
    text.remove_prefix(tag);
    if (text.empty()) break;
    text.remove_prefix(1);
    if (text.front() == '/') {
      text.remove_prefix(1);
      const std::string name = takeName(text);
      if (open.empty() || open.back() != name || !text.starts_with(">")) return "</" + name + "> closes nothing";
      open.pop_back();
      text.remove_prefix(1);
      continue;
    }
    const std::string name = takeName(text);
    if (name.empty()) return "a tag without name";
    std::vector<std::string> attributes;
    bool closed = false;
    if (const std::string fault = takeAttributes(text, attributes, closed); !fault.empty()) return fault;
    if (open.empty() && ++roots > 1) return "two roots";
    if (!closed) open.push_back(name);
  }
  if (!open.empty()) return open.back() + " stays open";
  return roots == 1 ? "" : "no root";
}

std::vector<Tag> startTags(std::string_view page) {
  std::vector<Tag> tags;
  for (std::size_t at = page.find('<'); at != std::string_view::npos; at = page.find('<', at + 1)) {
    std::string_view rest = page.substr(at + 1);
    if (rest.starts_with('/') || rest.starts_with("!DOCTYPE html>")) continue;
    Tag tag{takeName(rest), {}};
    bool closed = false;
    if (const std::string fault = takeAttributes(rest, tag.attributes, closed); !fault.empty())
      tag.name += " with " + fault;
    tags.push_back(std::move(tag));
  }
  return tags;
}

}  // namespace muelle::grader
