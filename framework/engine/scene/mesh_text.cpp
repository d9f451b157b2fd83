#include "engine/scene/mesh_text.h"

#include "base/text/count.h"
#include "base/text/printable.h"

#include <fmt/format.h>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <stdexcept>

namespace muelle::engine {

namespace {

constexpr std::string_view blanks = " \t\r\v\f";

}  // namespace

std::string shownWord(std::string_view word) {
  constexpr std::size_t most = 40;
  return printableLine(word.substr(0, most)) + (word.size() > most ? "..." : "");
}

MeshText::MeshText(std::string_view text, std::string name) : text_(text), name_(std::move(name)) {
  constexpr std::string_view byteOrderMark = "\xEF\xBB\xBF";
  if (text_.starts_with(byteOrderMark)) text_.remove_prefix(byteOrderMark.size());
  // Where lines end with CR alone, an LF behind the last line of a header is a byte of the numbers that follow.
  const std::size_t end = text_.find_first_of("\r\n");
  endsInBoth_ = end != std::string_view::npos && text_.substr(end).starts_with("\r\n");
}

void MeshText::failAt(int line, const std::string& complaint) const {
  throw std::runtime_error(fmt::format("{}:{}: {}", name_, std::max(1, line), complaint));
}

std::string_view MeshText::rawLine() {
  const std::size_t end = std::min(text_.find_first_of("\r\n", position_), text_.size());
  const std::string_view line = text_.substr(position_, end - position_);
  const std::size_t ending = endsInBoth_ && text_.substr(end).starts_with("\r\n") ? 2 : 1;
  position_ = std::min(end + ending, text_.size());
  ++linesRead_;
  return line;
}

bool MeshText::nextLine(char comment) {
  const auto cut = [&](std::string_view line) { return comment == '\0' ? line : line.substr(0, line.find(comment)); };
  while (position_ < text_.size()) {
    line_ = cut(rawLine());
    lineNumber_ = linesRead_;
    column_ = 0;
    if (joins_ && line_.ends_with('\\')) {
      joined_.clear();
      while (line_.ends_with('\\')) {
        joined_.append(line_.substr(0, line_.size() - 1)).push_back(' ');
        line_ = position_ < text_.size() ? cut(rawLine()) : std::string_view();
      }
      line_ = joined_.append(line_);
    }
    if (line_.find_first_not_of(blanks) != std::string_view::npos) return true;
  }
  line_ = {};
  column_ = 0;
  return false;
}

bool MeshText::hasWord() { return line_.find_first_not_of(blanks, column_) != std::string_view::npos; }

std::string_view MeshText::word() {
  const std::size_t begin = std::min(line_.find_first_not_of(blanks, column_), line_.size());
  column_ = std::min(line_.find_first_of(blanks, begin), line_.size());
  return line_.substr(begin, column_ - begin);
}

double MeshText::number() {
  std::string_view text = word();
  if (text.empty()) fail("a number is missing");
  const std::string_view whole = text;
  if (text.front() == '+') text.remove_prefix(1);
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size())
    fail(fmt::format("'{}' is no number", shownWord(whole)));
  return value;
}

std::int64_t MeshText::integer() {
  const std::string_view text = word();
  if (text.empty()) fail("an integer is missing");
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size())
    fail(fmt::format("'{}' is no integer", shownWord(text)));
  return value;
}

void MeshText::seekWord(char comment) {
  while (!hasWord()) {
    if (!nextLine(comment)) fail("the file ends too early");
  }
}

double MeshText::numberAnywhere(char comment) {
  seekWord(comment);
  return number();
}

std::int64_t MeshText::integerAnywhere(char comment) {
  seekWord(comment);
  return integer();
}

int checkedCount(const MeshText& at, std::int64_t count, const char* what, int most, std::size_t bytes,
                 std::size_t least) {
  const std::string noun = nounFor(count, what, what == std::string_view("vertex") ? "vertices" : "");
  if (count < 0) at.fail(fmt::format("{} {}: a count is not negative", count, noun));
  if (count > most) at.fail(fmt::format("{} {}: at most {} are read", count, noun, most));
  if (static_cast<std::size_t>(count) > bytes / least) {
    at.fail(fmt::format("{} {} {} not fit into the {} that {}: the file is cut short or its header wrong", count, noun,
                        count == 1 ? "does" : "do", counted(static_cast<long long>(bytes), "byte"),
                        bytes == 1 ? "follows" : "follow"));
  }
  return static_cast<int>(count);
}

void requireFinite(const Vec3& vertex, const MeshText& at) {
  // Squares of larger coordinates overflow, and those of a mesh in metres are far smaller.
  constexpr double most = 1e100;
  if (!(vertex.cwiseAbs().maxCoeff() <= most) || !vertex.allFinite()) {
    at.fail(fmt::format("a vertex lies at ({}, {}, {}); coordinates are finite and below 1e100", vertex[0], vertex[1],
                        vertex[2]));
  }
}

}  // namespace muelle::engine
