#pragma once
#include "grader/wire/codec.h"

namespace wire_test {

/// A struct of a contract with a field of every kind.
struct Sample {
  int count = 0;
  bool closed = false;
  double stiffness = 0;
  muelle::Vec3 position{0, 0, 0};
  muelle::VecX state;
  muelle::MatX jacobian;
  std::vector<muelle::Vec3> nodes;
  std::array<double, 2> range{};
};
MUELLE_STRUCT(Sample, count, closed, stiffness, position, state, jacobian, nodes, range)

/// A struct of structs.
struct Nested {
  Sample first;
  std::vector<Sample> others;
  Eigen::SparseMatrix<double> matrix;
};
MUELLE_STRUCT(Nested, first, others, matrix)

inline Sample sample(int n) {
  Sample s;
  s.count = -n;
  s.closed = n % 2 == 1;
  s.stiffness = 0.1 * n;
  s.position = muelle::Vec3(1, -2, n);
  s.state = muelle::VecX::LinSpaced(n, -1, 1);
  s.jacobian = muelle::MatX::Constant(n, n + 1, 2.5);
  for (int i = 0; i < n; ++i) s.nodes.push_back(muelle::Vec3::Constant(i));
  s.range = {-1e300, 5e-324};
  return s;
}

inline Nested nested() {
  Nested object;
  object.first = sample(2);
  object.others = {sample(0), sample(3)};
  object.matrix.resize(3, 4);
  object.matrix.insert(2, 1) = -7.5;
  object.matrix.insert(0, 3) = 1e-9;
  object.matrix.makeCompressed();
  return object;
}

template <class T>
std::vector<std::byte> bytesOf(const T& value) {
  using muelle::grader::wire::encode;
  muelle::grader::wire::Writer writer;
  encode(writer, value);
  return writer.bytes();
}

/// What stands in a message, all of it. Throws WireError.
template <class T>
T valueOf(std::span<const std::byte> bytes) {
  using muelle::grader::wire::decode;
  muelle::grader::wire::Reader reader(bytes);
  T value;
  decode(reader, value);
  reader.expectEnd();
  return value;
}

}  // namespace wire_test
