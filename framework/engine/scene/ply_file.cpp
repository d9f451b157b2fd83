#include "engine/scene/mesh_file.h"
#include "engine/scene/mesh_text.h"
#include "engine/scene/polygon_list.h"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace muelle::engine {

namespace {

constexpr std::int64_t mostElements = 10'000'000;  // of elements that are skipped
constexpr std::int64_t mostListLength = 1000;

enum class Type { Int8, Uint8, Int16, Uint16, Int32, Uint32, Float32, Float64 };

struct Property {
  std::string name;
  Type type = Type::Float32;
  bool isList = false;
  Type countType = Type::Uint8;
};

struct Element {
  std::string name;
  std::int64_t count = 0;
  std::vector<Property> properties;
};

enum class Format { Ascii, LittleEndian, BigEndian };

struct Header {
  Format format = Format::Ascii;
  std::vector<Element> elements;
};

std::size_t sizeOf(Type type) {
  constexpr std::size_t sizes[] = {1, 1, 2, 2, 4, 4, 4, 8};
  return sizes[static_cast<std::size_t>(type)];
}

Type typeNamed(std::string_view word, const MeshText& at) {
  constexpr std::pair<std::string_view, Type> names[] = {
      {"char", Type::Int8},     {"int8", Type::Int8},       {"uchar", Type::Uint8},    {"uint8", Type::Uint8},
      {"short", Type::Int16},   {"int16", Type::Int16},     {"ushort", Type::Uint16},  {"uint16", Type::Uint16},
      {"int", Type::Int32},     {"int32", Type::Int32},     {"uint", Type::Uint32},    {"uint32", Type::Uint32},
      {"float", Type::Float32}, {"float32", Type::Float32}, {"double", Type::Float64}, {"float64", Type::Float64},
  };
  for (const auto& [name, type] : names) {
    if (name == word) return type;
  }
  at.fail(fmt::format("'{}' is no type of PLY (float, int, uchar, ...)", shownWord(word)));
}

Property readProperty(MeshText& text) {
  Property property;
  std::string_view word = text.word();
  if (word == "list") {
    property.isList = true;
    property.countType = typeNamed(text.word(), text);
    if (property.countType == Type::Float32 || property.countType == Type::Float64) {
      text.fail("the length of a list is an integer");
    }
    word = text.word();
  }
  property.type = typeNamed(word, text);
  property.name = std::string(text.word());
  if (property.name.empty()) text.fail("a property has no name");
  return property;
}

Format formatNamed(std::string_view word, const MeshText& at) {
  if (word == "ascii") return Format::Ascii;
  if (word == "binary_little_endian") return Format::LittleEndian;
  if (word == "binary_big_endian") return Format::BigEndian;
  at.fail(
      fmt::format("'{}' is no format of PLY: ascii, binary_little_endian and binary_big_endian are", shownWord(word)));
}

Header readHeader(MeshText& text) {
  if (!text.nextLine('\0') || text.word() != "ply") text.fail("a PLY file begins with the word ply");
  Header header;
  bool hasFormat = false;
  while (text.nextLine('\0')) {
    const std::string_view word = text.word();
    if (word == "end_header") {
      if (!hasFormat) text.fail("the header names no format");
      return header;
    }
    if (word == "comment" || word == "obj_info") continue;
    if (word == "format") {
      header.format = formatNamed(text.word(), text);
      hasFormat = true;
    } else if (word == "element") {
      Element element;
      element.name = std::string(text.word());
      element.count = text.integer();
      const bool isVertex = element.name == "vertex";
      const bool isFace = element.name == "face";
      const std::int64_t most = isVertex ? mostVertices : isFace ? mostFaces : mostElements;
      if (element.count < 0 || element.count > most) {
        text.fail(fmt::format("{} elements '{}': 0 to {} are read", element.count, shownWord(element.name), most));
      }
      header.elements.push_back(std::move(element));
      if (header.elements.size() > 100) text.fail("more than 100 kinds of elements");
    } else if (word == "property") {
      if (header.elements.empty()) text.fail("a property before the first element");
      header.elements.back().properties.push_back(readProperty(text));
      if (header.elements.back().properties.size() > 100) text.fail("more than 100 properties of an element");
    } else {
      text.fail(fmt::format("'{}' does not belong into the header of a PLY file", shownWord(word)));
    }
  }
  text.fail("the header has no end_header");
}

/// The body: numbers one after the other, as text or as bytes.
class Body {
 public:
  Body(MeshText& text, Format format) : text_(text), format_(format), bytes_(text.rest()) {}

  bool isBinary() const { return format_ != Format::Ascii; }
  std::size_t bytesLeft() const { return isBinary() ? bytes_.size() : text_.rest().size() + text_.line().size() + 1; }

  double number(Type type) {
    if (!isBinary()) return text_.numberAnywhere('\0');
    switch (type) {
      case Type::Int8:
        return take<std::int8_t>();
      case Type::Uint8:
        return take<std::uint8_t>();
      case Type::Int16:
        return take<std::int16_t>();
      case Type::Uint16:
        return take<std::uint16_t>();
      case Type::Int32:
        return take<std::int32_t>();
      case Type::Uint32:
        return take<std::uint32_t>();
      case Type::Float32:
        return static_cast<double>(take<float>());
      case Type::Float64:
        return take<double>();
    }
    return 0.0;
  }

  std::int64_t integer(Type type) {
    const double value = number(type);
    if (value != std::floor(value) || std::abs(value) > 4294967295.0) {
      text_.fail(fmt::format("{} stands where an integer is expected", value));
    }
    return static_cast<std::int64_t>(value);
  }

  std::int64_t listLength(Type type, std::int64_t most = mostListLength) {
    const std::int64_t length = integer(type);
    if (length < 0 || length > most) text_.fail(fmt::format("a list has {} entries; 0 to {} are read", length, most));
    return length;
  }

  void skip(const Property& property) {
    const std::int64_t count = property.isList ? listLength(property.countType) : 1;
    for (std::int64_t i = 0; i < count; ++i) number(property.type);
  }

 private:
  template <class T>
  T take() {
    static_assert(std::endian::native == std::endian::little,
                  "the bytes of a PLY file are turned round only when it says so");
    if (bytes_.size() < sizeof(T)) text_.fail("the file ends too early");
    std::array<char, sizeof(T)> raw;
    std::copy_n(bytes_.begin(), sizeof(T), raw.begin());
    if (format_ == Format::BigEndian) std::ranges::reverse(raw);
    const T value = std::bit_cast<T>(raw);
    bytes_.remove_prefix(sizeof(T));
    return value;
  }

  MeshText& text_;
  Format format_;
  std::string_view bytes_;
};

/// The fewest bytes that one such element takes.
std::size_t leastBytes(const Element& element, bool binary) {
  std::size_t sum = 0;
  for (const Property& property : element.properties) {
    sum += binary ? sizeOf(property.isList ? property.countType : property.type) : 2;
  }
  return std::max<std::size_t>(sum, 1);
}

void readVertices(Body& body, const Element& element, SurfaceMesh& mesh, const MeshText& at) {
  std::array<bool, 3> found{};
  for (std::int64_t i = 0; i < element.count; ++i) {
    Vec3 vertex = Vec3::Zero();
    for (const Property& property : element.properties) {
      const std::size_t axis = property.name.size() == 1 ? std::string_view("xyz").find(property.name[0]) : 3;
      if (axis > 2 || property.isList) {
        body.skip(property);
        continue;
      }
      vertex[static_cast<Eigen::Index>(axis)] = body.number(property.type);
      found[axis] = true;
    }
    if (!found[0] || !found[1] || !found[2]) at.fail("the vertices have no properties x, y and z");
    requireFinite(vertex, at);
    mesh.vertices.push_back(vertex);
  }
}

bool namesCorners(const Property& property) {
  return property.isList && (property.name == "vertex_indices" || property.name == "vertex_index");
}

/// Reads an element's list of corners; its other properties are skipped.
void readCorners(Body& body, const Element& element, std::int64_t most, std::vector<std::int64_t>& corners) {
  corners.clear();
  for (const Property& property : element.properties) {
    if (!namesCorners(property)) {
      body.skip(property);
      continue;
    }
    const std::int64_t count = body.listLength(property.countType, most);
    for (std::int64_t j = 0; j < count; ++j) corners.push_back(body.integer(property.type));
  }
}

/// The triangles of a strip, every second one turned; -1 begins a new strip, and a corner given twice in a row, which
/// joins two strips to one, makes none.
void addStrip(const std::vector<std::int64_t>& corners, PolygonList& polygons, const MeshText& at) {
  std::size_t begin = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (corners[i] == -1) begin = i + 1;
    if (i < begin + 2) continue;
    const std::int64_t a = corners[i - 2];
    const std::int64_t b = corners[i - 1];
    const std::int64_t c = corners[i];
    if (a == b || b == c || c == a) continue;
    const bool turned = (i - begin) % 2 == 1;
    polygons.add(turned ? std::vector{b, a, c} : std::vector{a, b, c}, at);
  }
}

/// Reads the two ends of an edge; its other properties are skipped.
void readEdge(Body& body, const Element& element, const MeshText& at, std::vector<std::int64_t>& ends) {
  ends.clear();
  for (const Property& property : element.properties) {
    const bool isEnd = !property.isList && (property.name == "vertex1" || property.name == "vertex2");
    if (isEnd) {
      ends.push_back(body.integer(property.type));
    } else {
      body.skip(property);
    }
  }
  if (ends.size() != 2) at.fail("the edges have no properties vertex1 and vertex2");
}

/// Reads the elements of one kind into the mesh or the list of its faces and lines; edges are skipped where faces are
/// wanted, and noted.
void readElements(Body& body, const Element& element, MeshPart wanted, SurfaceMesh& mesh, PolygonList& polygons,
                  const MeshText& at) {
  std::vector<std::int64_t> corners;
  if (element.name == "vertex") return readVertices(body, element, mesh, at);
  for (std::int64_t i = 0; i < element.count; ++i) {
    if (element.name == "face") {
      readCorners(body, element, mostListLength, corners);
      polygons.add(corners, at);
    } else if (element.name == "tristrips") {
      readCorners(body, element, std::int64_t{3} * mostFaces, corners);
      addStrip(corners, polygons, at);
    } else if (element.name == "edge" && wanted == MeshPart::Lines) {
      readEdge(body, element, at, corners);
      polygons.addLine(corners, at);
    } else {
      for (const Property& property : element.properties) body.skip(property);
      if (element.name == "edge") polygons.addLine({}, at);
    }
  }
}

}  // namespace

SurfaceMesh parsePly(std::string_view bytes, const std::string& name, MeshPart wanted) {
  MeshText text(bytes, name);
  const Header header = readHeader(text);
  Body body(text, header.format);
  SurfaceMesh mesh;
  PolygonList polygons;
  for (const Element& element : header.elements) {
    if (element.count == 0) continue;
    // A name of the file stands in this message only when it is one of the two that count.
    const char* what = element.name == "vertex" ? "vertex" : element.name == "face" ? "face" : "element";
    checkedCount(text, element.count, what, static_cast<int>(mostElements), body.bytesLeft(),
                 leastBytes(element, body.isBinary()));
    readElements(body, element, wanted, mesh, polygons, text);
  }
  polygons.cutInto(mesh, text, 0, wanted);
  return mesh;
}

}  // namespace muelle::engine
