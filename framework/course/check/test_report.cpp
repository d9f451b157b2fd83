#include "course/check/test_report.h"

#include "base/text/lists.h"
#include "base/text/printable.h"
#include "course/testing/mismatch_text.h"

#include <fmt/format.h>

namespace muelle {

namespace {

/// "; 2 were not run: ThirdLaw.SumIsZero, Energy.IsKept"
std::string leftOut(std::vector<std::string> names) {
  constexpr std::size_t most = 6;
  if (names.empty()) return "";
  const char* were = names.size() == 1 ? "was" : "were";
  const std::string more = names.size() > most ? fmt::format(" and {} more", names.size() - most) : "";
  const std::size_t count = names.size();
  names.resize(std::min(count, most));
  return fmt::format("; {} {} not run: {}{}", count, were, joined(names, ", "), more);
}

}  // namespace

std::string countTests(const TestReport& report) {
  if (report.total == 0) return "no public test ran";
  return fmt::format("{} of {} public tests pass{}", report.passed, report.total, leftOut(report.notRun));
}

std::string showFailure(const FailedTest& failure) {
  std::string text;
  if (!failure.property.empty()) text += fmt::format("  {}\n", failure.property);
  if (!failure.call.empty()) text += fmt::format("    {};\n", failure.call);
  // The first message is enough to mend; a test with ten components would hide the rest.
  constexpr std::size_t most = 2;
  std::size_t shown = 0;
  for (Mismatch mismatch : failure.mismatches) {
    if (shown++ == most) break;
    // "springForce(xa, xb, k, L0)": the call above says it with numbers.
    if (mismatch.ofCall && !failure.call.empty()) mismatch.expression.clear();
    text += indented(sentence(mismatch) + "\n", "    ");
  }
  for (const std::string& message : failure.messages) {
    if (shown++ >= most) break;
    text += indented(cutText(message, 12, 2000) + "\n", "    ");
  }
  return printableText(text);
}

}  // namespace muelle
