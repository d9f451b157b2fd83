#include "course/testing/mismatch.h"

#include <fmt/format.h>
#include <cmath>
#include <utility>

namespace muelle {

namespace {

thread_local std::optional<Mismatch> noted;
thread_local const MismatchLabel* innermost = nullptr;

/// ", component 2" of a vector, ", entry (1, 2)" of a matrix; "" for a number and for a wrong size.
std::string place(const Mismatch& mismatch) {
  if (mismatch.row < 0 || mismatch.isSize()) return "";
  return mismatch.cols == 1 ? fmt::format("component {}", mismatch.row)
                            : fmt::format("entry ({}, {})", mismatch.row, mismatch.col);
}

std::string size(long rows, long cols) {
  return cols == 1 ? fmt::format("{} components", rows) : fmt::format("{} x {} entries", rows, cols);
}

/// A NaN has no sign that a student should read.
std::string shown(double number) { return std::isnan(number) ? "NaN" : fmt::format("{:.10g}", number); }

std::string withUnit(const std::string& number, const std::string& unit) {
  return unit.empty() ? number : number + ' ' + unit;
}

/// "springForce" of "springForce(s.xa, s.xb)": the arguments' names are the test's own, and the call shows their
/// values.
std::string calledFunction(const std::string& expression) {
  const std::size_t open = expression.find('(');
  int depth = 0;
  for (std::size_t i = open; i < expression.size(); ++i) {
    if (expression[i] == '(') ++depth;
    if (expression[i] == ')' && --depth == 0)
      return i + 1 == expression.size() ? expression.substr(0, open) : expression;
  }
  return expression;
}

std::string what(const Mismatch& mismatch) {
  const std::string source = mismatch.ofCall ? calledFunction(mismatch.expression) : mismatch.expression;
  const std::string& name = mismatch.label.empty() ? source : mismatch.label;
  const std::string where = place(mismatch);
  return name.empty() || where.empty() ? name + where : name + ", " + where;
}

}  // namespace

MismatchWords wordsOf(const Mismatch& mismatch) {
  if (mismatch.isStatement()) return {mismatch.says, "", "", ""};
  if (mismatch.isSize())
    return {what(mismatch), size(mismatch.gotRows, mismatch.gotCols), size(mismatch.rows, mismatch.cols), ""};
  const std::string expected = withUnit(shown(mismatch.expected), mismatch.unit);
  if (!std::isfinite(mismatch.got))
    return {what(mismatch), shown(mismatch.got) + ", which is not a finite number", expected, ""};
  return {what(mismatch), withUnit(shown(mismatch.got), mismatch.unit), expected,
          fmt::format("difference {:.3g}, tolerance {:.3g}", mismatch.got - mismatch.expected, mismatch.tolerance)};
}

std::string sentence(const Mismatch& mismatch) {
  const MismatchWords words = wordsOf(mismatch);
  if (mismatch.isStatement()) return words.what;
  const bool holdsComma = !mismatch.isSize() && !std::isfinite(mismatch.got);
  return fmt::format("{}{}got {}{} expected {}{}", words.what, words.what.empty() ? "" : ": ", words.got,
                     holdsComma ? ";" : ",", words.expected,
                     words.bounds.empty() ? "" : fmt::format(" ({})", words.bounds));
}

std::string asStudentsWrite(std::string source) {
  constexpr std::string_view prefix = "submission::";
  for (std::size_t at = source.find(prefix); at != std::string::npos; at = source.find(prefix, at))
    source.erase(at, prefix.size());
  return source;
}

void noteMismatch(std::optional<Mismatch> mismatch) { noted = std::move(mismatch); }

std::optional<Mismatch> takeMismatch(std::string_view message) {
  std::optional<Mismatch> taken = std::exchange(noted, std::nullopt);
  if (taken && !message.starts_with(sentence(*taken))) return std::nullopt;
  return taken;
}

MismatchLabel::MismatchLabel(std::string label, std::string unit)
    : label_(std::move(label)), unit_(std::move(unit)), outer_(innermost) {
  innermost = this;
}

MismatchLabel::~MismatchLabel() { innermost = outer_; }

const MismatchLabel* MismatchLabel::current() { return innermost; }

}  // namespace muelle
