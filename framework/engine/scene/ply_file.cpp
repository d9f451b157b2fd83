#include "engine/scene/mesh_file.h"
#include "engine/scene/mesh_text.h"

#include <fmt/format.h>
#include <bit>
#include <cmath>
#include <cstring>

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

struct Header {
  bool binary = false;
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
      const std::string_view format = text.word();
      if (format != "ascii" && format != "binary_little_endian") {
        text.fail(fmt::format("the format '{}' is not read; ascii and binary_little_endian are", shownWord(format)));
      }
      header.binary = format != "ascii";
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
  Body(MeshText& text, bool binary) : text_(text), binary_(binary), bytes_(text.rest()) {}

  std::size_t bytesLeft() const { return binary_ ? bytes_.size() : text_.rest().size() + text_.line().size() + 1; }

  double number(Type type) {
    if (!binary_) return text_.numberAnywhere('\0');
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

  std::int64_t listLength(Type type) {
    const std::int64_t length = integer(type);
    if (length < 0 || length > mostListLength) {
      text_.fail(fmt::format("a list has {} entries; 0 to {} are read", length, mostListLength));
    }
    return length;
  }

  void skip(const Property& property) {
    const std::int64_t count = property.isList ? listLength(property.countType) : 1;
    for (std::int64_t i = 0; i < count; ++i) number(property.type);
  }

 private:
  template <class T>
  T take() {
    static_assert(std::endian::native == std::endian::little, "the bytes of a PLY file are taken as they are");
    if (bytes_.size() < sizeof(T)) text_.fail("the file ends too early");
    T value;
    std::memcpy(&value, bytes_.data(), sizeof(T));
    bytes_.remove_prefix(sizeof(T));
    return value;
  }

  MeshText& text_;
  bool binary_;
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

void readFaces(Body& body, const Element& element, std::int64_t vertexCount, SurfaceMesh& mesh, const MeshText& at) {
  std::vector<std::int64_t> corners;
  for (std::int64_t i = 0; i < element.count; ++i) {
    corners.clear();
    for (const Property& property : element.properties) {
      if (!property.isList || (property.name != "vertex_indices" && property.name != "vertex_index")) {
        body.skip(property);
        continue;
      }
      const std::int64_t count = body.listLength(property.countType);
      for (std::int64_t j = 0; j < count; ++j) corners.push_back(body.integer(property.type));
    }
    addPolygon(mesh, corners, vertexCount, at);
  }
}

}  // namespace

SurfaceMesh parsePly(std::string_view bytes, const std::string& name) {
  MeshText text(bytes, name);
  const Header header = readHeader(text);
  Body body(text, header.binary);
  std::int64_t vertexCount = 0;
  for (const Element& element : header.elements) {
    if (element.name == "vertex") vertexCount = element.count;
  }
  SurfaceMesh mesh;
  for (const Element& element : header.elements) {
    if (element.count == 0) continue;
    // A name of the file stands in this message only when it is one of the two that count.
    const char* what = element.name == "vertex" ? "vertices" : element.name == "face" ? "faces" : "elements";
    checkedCount(text, element.count, what, static_cast<int>(mostElements), body.bytesLeft(),
                 leastBytes(element, header.binary));
    if (element.name == "vertex") {
      readVertices(body, element, mesh, text);
    } else if (element.name == "face") {
      readFaces(body, element, vertexCount, mesh, text);
    } else {
      for (std::int64_t i = 0; i < element.count; ++i) {
        for (const Property& property : element.properties) body.skip(property);
      }
    }
  }
  if (mesh.triangles.empty()) text.fail("no face");
  return mesh;
}

}  // namespace muelle::engine
