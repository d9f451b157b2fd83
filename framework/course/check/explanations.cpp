#include "course/check/explanations.h"

#include "base/text/words.h"
#include "course/check/plain_types.h"

#include <fmt/format.h>

namespace muelle {

namespace {

/// The part of the message between the n-th pair of quotes, from 0.
std::string quoted(std::string_view message, int n) {
  std::size_t at = 0;
  for (int i = 0;; ++i) {
    const std::size_t open = message.find('\'', at);
    const std::size_t close = open == std::string_view::npos ? open : message.find('\'', open + 1);
    if (close == std::string_view::npos) return "";
    if (i == n) return std::string(message.substr(open + 1, close - open - 1));
    at = close + 1;
  }
}

/// Eigen's static assertions speak in capitals; the frequent ones in words.
struct Translation {
  std::string_view name;
  std::string_view meaning;
};
constexpr Translation staticAssertions[] = {
    {"YOU_MIXED_DIFFERENT_NUMERIC_TYPES",
     "float, int and double do not mix in Eigen: use the double types throughout (Vec3, VecX, Mat3)"},
    {"INVALID_VECTOR_VECTOR_PRODUCT",
     "* does not multiply two vectors: a.dot(b) is the scalar product, a.cross(b) the vector product, "
     "a.cwiseProduct(b) works component by component"},
    {"INVALID_MATRIX_PRODUCT", "the sizes do not fit: in A * B the columns of A must be as many as the rows of B"},
    {"IS_NOT_A_LVALUE",
     "this cannot be changed: it is const, or an expression kept by `auto`; copy it into a variable of type Vec3"},
    {"OUT_OF_RANGE_ACCESS", "the vector has no such component: a Vec2 has x() and y(), a Vec3 also z()"},
    {"ONLY_FOR_VECTORS_OF_A_SPECIFIC_SIZE", "this works only for vectors of another size (cross() needs two Vec3)"},
    {"ONLY_FOR_1x1_EXPRESSIONS", "only a 1 x 1 product can become a number: use a.dot(b)"},
    {"VECTOR_METHOD_ON_A_MATRIX", "this works for vectors only, and this is a matrix"},
    {"FLOATING_POINT_ARGUMENT_PASSED",
     "wrong number of components (a Vec3 takes three numbers), or a size or index that is no integer"},
};

std::string explainStaticAssertion(std::string_view message, const std::vector<std::string>& mixed) {
  if (contains(message, "YOU_MIXED_MATRICES_OF_DIFFERENT_SIZES")) {
    const std::string which = mixed.size() == 2 ? fmt::format(" (a {} and a {})", mixed[0], mixed[1]) : "";
    return fmt::format("vectors or matrices of different sizes are mixed in this line{}", which);
  }
  for (const Translation& translation : staticAssertions) {
    if (contains(message, translation.name)) return std::string(translation.meaning);
  }
  return "";
}

bool isNumber(std::string_view type) {
  return contains(type, "double") || contains(type, "int") || contains(type, "float") || contains(type, "long");
}

/// "no match for 'operator+' (operand types are 'A' and 'B')"
std::string explainOperator(std::string_view message) {
  const std::string name = quoted(message, 0).substr(8);
  const std::size_t operands = message.rfind("(operand type");
  if (operands == std::string_view::npos) return "";
  const std::string plain = withPlainTypes(message.substr(operands));
  const std::string left = quoted(plain, 0);
  const std::string right = quoted(plain, 1);
  const bool isSum = name == "+" || name == "-" || name == "+=" || name == "-=";
  const bool mixesNumber = isNumber(left) != isNumber(right);
  if (isSum && mixesNumber) {
    return "a number and a vector do not add up: give the number a direction first (a number times a unit vector)";
  }
  if (name == "/" && !isNumber(right)) return "a vector cannot divide: divide by a number, such as its length .norm()";
  const bool assigns = name == "=" || name == "+=" || name == "-=" || name == "*=" || name == "/=";
  if (assigns && left.starts_with("const ")) {
    return "the left side is const and cannot be changed: copy it into a variable of your own";
  }
  if (name == "=" && mixesNumber) return "one side is a number, the other a vector";
  if (name == "^") return "^ is no power in C++: write x * x or std::pow(x, 2)";
  if (name == "<" || name == ">" || name == "<=" || name == ">=" || name == "==") {
    return mixesNumber ? "a vector cannot be compared with a number: compare its length .norm()" : "";
  }
  if (right.empty()) return "";
  return fmt::format("there is no {} between '{}' and '{}'", name, left, right);
}

/// "cannot convert 'A' to 'B' in initialization", "could not convert 'expression' from 'A' to 'B'".
std::string explainConversion(std::string_view message) {
  const std::string plain = withPlainTypes(message);
  const int first = contains(message, "could not convert") ? 1 : 0;
  const std::string from = quoted(plain, first);
  const std::string to = quoted(plain, first + 1);
  const auto isVector = [](std::string_view type) {
    return contains(type, "Vec") || contains(type, "Eigen") || contains(type, "Mat");
  };
  if (isVector(from) && isNumber(to)) {
    return "a vector stands where a number is needed: .norm() is its length, a.dot(b) the scalar product";
  }
  if (isNumber(from) && isVector(to)) {
    return "a number stands where a vector is needed: multiply it by a direction; Vec3::Zero() is the zero vector";
  }
  return "";
}

std::string explainMember(std::string_view message) {
  const std::string member = quoted(message, 1);
  if (!contains(message, "Eigen::")) return "";
  if (member == "length" || member == "magnitude" || member == "mag" || member == "len" || member == "abs") {
    return "the length of a vector is .norm(), its square .squaredNorm()";
  }
  if (member == "normalise" || member == "unit") return "the unit vector is .normalized()";
  if (member == "x" || member == "y" || member == "z") return "components are functions in Eigen: v.x(), or v[0]";
  return "Eigen's vectors have no such member; some that they have: norm(), dot(), cross(), normalized(), "
         "segment<3>(i)";
}

}  // namespace

std::string explainMessage(std::string_view message, const std::vector<std::string>& mixed) {
  if (contains(message, "static assertion failed")) return explainStaticAssertion(message, mixed);
  if (contains(message, "no match for 'operator") || contains(message, "no match for operator"))
    return explainOperator(message);
  if (contains(message, "cannot convert '") || contains(message, "could not convert '"))
    return explainConversion(message);
  if (contains(message, "has no member named")) return explainMember(message);
  if (contains(message, "operands to '?:' have different types") && contains(message, "Eigen::")) {
    return "give both branches of ?: one type: c ? Vec3(...) : Vec3(...), or write an if";
  }
  if (contains(message, "discards qualifiers") || contains(message, "read-only") ||
      contains(message, "of reference to const")) {
    return "arguments that are const cannot be changed: copy them into a variable of your own";
  }
  if (contains(message, "a function-definition is not allowed here"))
    return "a { of the function above is never closed";
  if (contains(message, "expected '}' at end of input")) return "a { above is never closed";
  if (contains(message, "redefinition of")) return "it is written twice in the file: keep one";
  if (contains(message, "ambiguating new declaration")) return "the contract gives this function another return type";
  if (contains(message, "no return statement") || contains(message, "control reaches end of non-void")) {
    return "a way through the function returns nothing: what the caller gets is then garbage";
  }
  if (contains(message, "is used uninitialized") || contains(message, "may be used uninitialized")) {
    return "it is read before a value was given to it";
  }
  if (contains(message, "incomplete type") && contains(message, "Eigen::")) {
    return "write #include <Eigen/Dense> at the top of the file: decompositions, inverse() and determinant() need it";
  }
  if (contains(message, "No such file or directory")) {
    return "the check finds the contract, the harness, Eigen and the standard library, no other file";
  }
  if (contains(message, "invalid operands of types") && contains(message, "operator^")) {
    return "^ is no power in C++: write x * x or std::pow(x, 2)";
  }
  return "";
}

}  // namespace muelle
