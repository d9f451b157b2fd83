#include "grader/remote/finding_text.h"

#include "base/text/printable.h"
#include "course/check/sanitizer_report.h"

#include <fmt/format.h>
#include <string_view>

namespace muelle::grader {

std::string findingText(const std::string& finding) {
  const std::string sentence(sanitizerSentence(finding));
  if (sentence.empty()) return fmt::format("uses memory wrongly ({})", printableText(finding.substr(0, 60)));
  const bool hasPlace = finding.starts_with("missing-return ") || finding.starts_with("invalid-value ");
  if (!hasPlace) return sentence;
  return fmt::format("{} at {}", sentence, printableText(finding.substr(finding.find(' ') + 1, 200)));
}

}  // namespace muelle::grader
