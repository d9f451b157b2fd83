#include "grader/remote/finding_text.h"

#include "base/text/printable.h"

#include <fmt/format.h>
#include <array>
#include <string_view>

namespace muelle::grader {

namespace {

struct Meaning {
  std::string_view beginning;
  const char* text;
};

constexpr std::array meanings{
    Meaning{"stack-use-after", "keeps a reference to a value that is gone (auto of an Eigen expression?)"},
    Meaning{"heap-use-after-free",
            "uses memory that has been given back: a reference or iterator into a std::vector "
            "that has grown, or a value that is gone"},
    Meaning{"heap-buffer-overflow", "reads or writes beyond the end of a std::vector or of memory from new"},
    Meaning{"container-overflow", "reads or writes beyond the end of a std::vector"},
    Meaning{"stack-buffer-overflow", "reads or writes beyond the end of a local array or variable"},
    Meaning{"stack-buffer-underflow", "reads or writes before the beginning of a local array or variable"},
    Meaning{"dynamic-stack-buffer-overflow", "reads or writes beyond the end of a local array"},
    Meaning{"global-buffer-overflow", "reads or writes beyond the end of a global array or constant"},
    Meaning{"stack-overflow", "ran out of stack: does it call itself without end, or hold a huge local array?"},
    Meaning{"attempting double-free", "gives memory back twice"},
    Meaning{"double-free", "gives memory back twice"},
    Meaning{"out-of-memory", "asks for more memory than there is"},
    Meaning{"allocation-size-too-big", "asks for more memory than there is"},
    Meaning{"calloc-overflow", "asks for more memory than there is"},
};

}  // namespace

std::string findingText(const std::string& finding) {
  constexpr std::string_view missingReturn = "missing-return";
  if (finding.starts_with(missingReturn)) {
    const std::string place = printableText(finding.substr(missingReturn.size()).substr(0, 200));
    return fmt::format("reached the end of a function without a return{}{}", place.empty() ? "" : " at", place);
  }
  for (const Meaning& meaning : meanings) {
    if (finding.starts_with(meaning.beginning)) return meaning.text;
  }
  return fmt::format("uses memory wrongly ({})", printableText(finding.substr(0, 60)));
}

}  // namespace muelle::grader
