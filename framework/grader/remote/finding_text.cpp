#include "grader/remote/finding_text.h"

#include "base/text/printable.h"
#include "course/check/sanitizer_report.h"

#include <fmt/format.h>
#include <string_view>

namespace muelle::grader {

std::string findingText(const std::string& finding) {
  constexpr std::string_view missingReturn = "missing-return";
  const std::string sentence(sanitizerSentence(finding));
  if (sentence.empty()) return fmt::format("uses memory wrongly ({})", printableText(finding.substr(0, 60)));
  if (!finding.starts_with(missingReturn)) return sentence;
  const std::string place = printableText(finding.substr(missingReturn.size()).substr(0, 200));
  return fmt::format("{}{}{}", sentence, place.empty() ? "" : " at", place);
}

}  // namespace muelle::grader
