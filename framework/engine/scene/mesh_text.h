#pragma once
#include "engine/scene/surface_mesh.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace muelle::engine {

/// Reads words and numbers of a mesh file line by line; knows where it is when it complains.
class MeshText {
 public:
  MeshText(std::string_view text, std::string name) : text_(text), name_(std::move(name)) {}

  /// Goes to the next line that has words once `comment` and what follows it are cut; false at the end.
  bool nextLine(char comment);
  /// The words of the present line, one after the other; empty when there are no more.
  std::string_view word();
  bool hasWord();
  double number();
  std::int64_t integer();
  /// As word(), going to the next line at the end of one; complains at the end of the file.
  double numberAnywhere(char comment);
  std::int64_t integerAnywhere(char comment);

  std::string_view line() const { return line_; }
  /// What lies behind the present line.
  std::string_view rest() const { return text_.substr(position_); }
  [[noreturn]] void fail(const std::string& complaint) const;

 private:
  void seekWord(char comment);

  std::string_view text_;
  std::string name_;
  std::size_t position_ = 0;
  std::string_view line_;
  std::size_t column_ = 0;
  int lineNumber_ = 0;
};

/// A word of a file for a message: visible characters, not too many.
std::string shownWord(std::string_view word);

/// A count in a header: complains, before anything is allocated, when it is negative, above `most`, or more than
/// `bytes` bytes can hold at `least` bytes each.
int checkedCount(const MeshText& at, std::int64_t count, const char* what, int most, std::size_t bytes,
                 std::size_t least);

/// Adds a polygon as triangles that share its first corner; complains of corners that are no vertices, appear twice, or
/// are fewer than three.
void addPolygon(SurfaceMesh& mesh, const std::vector<std::int64_t>& corners, std::int64_t vertexCount,
                const MeshText& at);

/// Complains of a coordinate that is not finite.
void requireFinite(const Vec3& vertex, const MeshText& at);

}  // namespace muelle::engine
