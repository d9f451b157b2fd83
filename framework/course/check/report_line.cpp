#include "course/check/report_line.h"

namespace muelle {

std::string reportLine(std::string_view kind, std::string_view text) {
  std::string line(kind);
  line += '\t';
  for (const char c : text) {
    if (c == '\n') {
      line += "\\n";
    } else if (c == '\\') {
      line += "\\\\";
    } else {
      line += c;
    }
  }
  return line + '\n';
}

std::vector<std::pair<std::string, std::string>> readReport(std::string_view report) {
  std::vector<std::pair<std::string, std::string>> entries;
  while (!report.empty()) {
    const std::size_t end = report.find('\n');
    if (end == std::string_view::npos) break;
    const std::string_view line = report.substr(0, end);
    report.remove_prefix(end + 1);
    const std::size_t tab = line.find('\t');
    if (tab == std::string_view::npos) continue;
    std::string text;
    for (std::size_t i = tab + 1; i < line.size(); ++i) {
      const bool escapes = line[i] == '\\' && i + 1 < line.size();
      if (escapes) ++i;
      text += escapes && line[i] == 'n' ? '\n' : line[i];
    }
    entries.emplace_back(line.substr(0, tab), text);
  }
  return entries;
}

}  // namespace muelle
