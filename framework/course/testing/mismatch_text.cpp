#include "course/testing/mismatch_text.h"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdlib>

namespace muelle {

namespace {

constexpr std::string_view bitsMark = "bits:";
/// Between fields: the unit separator, which no source and no label holds.
constexpr char separator = '\x1f';
constexpr std::size_t fieldCount = 15;

std::optional<double> numberOfBits(std::string_view digits) {
  std::uint64_t bits = 0;
  const char* end = digits.data() + digits.size();
  const auto [rest, error] = std::from_chars(digits.data(), end, bits, 16);
  if (digits.size() != 16 || error != std::errc() || rest != end) return std::nullopt;
  return std::bit_cast<double>(bits);
}

std::optional<long> integer(std::string_view text) {
  long value = 0;
  const char* end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || rest != end) return std::nullopt;
  return value;
}

std::string field(std::string text) {
  std::replace(text.begin(), text.end(), separator, ' ');
  return text;
}

/// Reads the fields one after the other; a bad one makes all of them bad.
class Fields {
 public:
  explicit Fields(std::string_view text) : rest_(text) {
    isGood_ = static_cast<std::size_t>(std::count(text.begin(), text.end(), separator)) == fieldCount - 1;
  }
  std::string text() {
    const std::size_t end = std::min(rest_.find(separator), rest_.size());
    std::string taken(rest_.substr(0, end));
    rest_.remove_prefix(std::min(end + 1, rest_.size()));
    return taken;
  }
  long whole() { return valueOf(integer(text())); }
  double number() { return valueOf(exactNumber(text())); }
  bool isGood() const { return isGood_; }

 private:
  template <class Value>
  Value valueOf(const std::optional<Value>& value) {
    if (!value) isGood_ = false;
    return value.value_or(Value());
  }

  std::string_view rest_;
  bool isGood_ = true;
};

}  // namespace

std::string exactText(double number) {
  if (std::isfinite(number)) return fmt::format("{}", number);
  return fmt::format("{}{:016x}", bitsMark, std::bit_cast<std::uint64_t>(number));
}

std::optional<double> exactNumber(std::string_view text) {
  if (text.starts_with(bitsMark)) return numberOfBits(text.substr(bitsMark.size()));
  const bool isDecimal = !text.empty() && text.find_first_not_of("+-.0123456789e") == std::string_view::npos;
  if (!isDecimal) return std::nullopt;
  const std::string copy(text);
  char* end = nullptr;
  const double number = std::strtod(copy.c_str(), &end);
  if (end != copy.c_str() + copy.size() || !std::isfinite(number)) return std::nullopt;
  return number;
}

std::string mismatchText(const Mismatch& m) {
  const std::array<std::string, fieldCount> fields{field(m.label),
                                                   field(m.expression),
                                                   m.ofCall ? "1" : "0",
                                                   field(m.call),
                                                   fmt::format("{}", m.row),
                                                   fmt::format("{}", m.col),
                                                   fmt::format("{}", m.rows),
                                                   fmt::format("{}", m.cols),
                                                   fmt::format("{}", m.gotRows),
                                                   fmt::format("{}", m.gotCols),
                                                   exactText(m.got),
                                                   exactText(m.expected),
                                                   exactText(m.tolerance),
                                                   field(m.unit),
                                                   field(m.says)};
  std::string text;
  for (const std::string& each : fields) {
    if (&each != fields.data()) text += separator;
    text += each;
  }
  return text;
}

std::optional<Mismatch> readMismatch(std::string_view text) {
  Fields fields(text);
  Mismatch m;
  m.label = fields.text();
  m.expression = fields.text();
  m.ofCall = fields.whole() != 0;
  m.call = fields.text();
  for (long* place : {&m.row, &m.col, &m.rows, &m.cols, &m.gotRows, &m.gotCols}) *place = fields.whole();
  for (double* value : {&m.got, &m.expected, &m.tolerance}) *value = fields.number();
  m.unit = fields.text();
  m.says = fields.text();
  if (!fields.isGood()) return std::nullopt;
  return m;
}

}  // namespace muelle
