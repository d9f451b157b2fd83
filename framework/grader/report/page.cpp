#include "grader/report/page.h"

#include "base/text/html.h"
#include "grader/report/page_style.h"

#include <fmt/format.h>
#include <algorithm>
#include <string_view>

namespace muelle::grader {

namespace {

/// Curves are images with their own, scriptless world; nothing else is loaded and nothing runs.
constexpr const char* policy =
    "default-src 'none'; style-src 'unsafe-inline'; img-src data:; base-uri 'none'; form-action 'none'";

/// Letters that mean nothing in an address (RFC 3986, section 2.3).
bool isUnreserved(char c) {
  constexpr std::string_view others = "0123456789-._~";
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || others.find(c) != std::string_view::npos;
}

}  // namespace

std::string page(const std::string& title, const std::string& body, const std::string& style) {
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"{}\">\n<meta name=\"referrer\" content=\"no-referrer\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>{}</title>\n"
      "<style>{}{}</style>\n</head>\n<body>\n<main>\n{}</main>\n</body>\n</html>\n",
      policy, escapeHtml(title), pageStyle, style, body);
}

std::string classOf(double points, double most) {
  if (points >= most) return "passed";
  return points > 0.0 ? "part" : "failed";
}

std::string bar(double points, double most) {
  const double part = most > 0.0 ? std::clamp(points / most, 0.0, 1.0) : 0.0;
  return fmt::format(
      "<svg class=\"bar\" viewBox=\"0 0 100 8\" preserveAspectRatio=\"none\" role=\"img\" aria-label=\"{0:.0f} %\">"
      "<rect class=\"track\" width=\"100\" height=\"8\"/><rect class=\"fill\" width=\"{1:.2f}\" height=\"8\"/></svg>",
      100.0 * part, 100.0 * part);
}

std::string paragraph(const char* kind, const std::string& text) {
  return text.empty() ? "" : fmt::format("<p class=\"{}\">{}</p>\n", kind, escapeHtml(text));
}

std::string pageFooter(const std::string& sandbox, const std::string& heading, const std::vector<std::string>& notes) {
  std::string html = fmt::format("<footer class=\"soft\">\n<p>Sandbox: {}</p>\n", escapeHtml(sandbox));
  if (!notes.empty()) {
    html += fmt::format("<p>{}</p>\n<ul>\n", escapeHtml(heading));
    for (const std::string& note : notes) html += fmt::format("<li>{}</li>\n", escapeHtml(note));
    html += "</ul>\n";
  }
  return html + "</footer>\n";
}

std::string relativeLink(const std::string& path) {
  std::string link;
  for (const char c : path) {
    link += isUnreserved(c) || c == '/' ? std::string(1, c)
                                        : fmt::format("%{:02X}", static_cast<unsigned>(static_cast<unsigned char>(c)));
  }
  return link;
}

}  // namespace muelle::grader
