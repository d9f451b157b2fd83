#pragma once
#include "engine/scene/surface_mesh.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace muelle::engine {

/// Reads words and numbers of a mesh file line by line; knows where it is when it complains. A line ends with LF, CR LF
/// or CR, whichever ends the first; a byte order mark before it is skipped.
class MeshText {
 public:
  MeshText(std::string_view text, std::string name);

  /// From here on a line that ends in a backslash goes on in the next one (OBJ).
  void joinLines() { joins_ = true; }

  /// Goes to the next line that has words once `comment` and what follows it are cut; false at the end.
  bool nextLine(char comment);
  /// The words of the present line, one after the other; empty when there are no more.
  std::string_view word();
  bool hasWord();
  /// Puts back the last `count` characters of the word just read.
  void unread(std::size_t count) { column_ -= count; }
  double number();
  std::int64_t integer();
  /// As word(), going to the next line at the end of one; complains at the end of the file.
  double numberAnywhere(char comment);
  std::int64_t integerAnywhere(char comment);

  std::string_view line() const { return line_; }
  /// What lies behind the present line.
  std::string_view rest() const { return text_.substr(position_); }
  /// The number of the present line, counted from 1; of joined lines the first.
  int lineNumber() const { return lineNumber_; }
  [[noreturn]] void fail(const std::string& complaint) const { failAt(lineNumber_, complaint); }
  [[noreturn]] void failAt(int line, const std::string& complaint) const;

 private:
  std::string_view rawLine();
  void seekWord(char comment);

  std::string_view text_;
  std::string name_;
  std::size_t position_ = 0;
  std::string_view line_;
  std::string joined_;  ///< what line_ is a view of when it is more than one
  std::size_t column_ = 0;
  int lineNumber_ = 0;
  int linesRead_ = 0;
  bool joins_ = false;
  bool endsInBoth_ = false;  ///< lines end with CR LF
};

/// A word of a file for a message: visible characters, not too many.
std::string shownWord(std::string_view word);

/// A count in a header: complains, before anything is allocated, when it is negative, above `most`, or more than
/// `bytes` bytes can hold at `least` bytes each. `what` is one of them: "vertex".
int checkedCount(const MeshText& at, std::int64_t count, const char* what, int most, std::size_t bytes,
                 std::size_t least);

/// Complains of a coordinate that is not finite.
void requireFinite(const Vec3& vertex, const MeshText& at);

}  // namespace muelle::engine
