#include "grader/wire/codec.h"

namespace muelle::grader::wire {

void encode(Writer& writer, const std::string& text) {
  writer.number(static_cast<std::uint64_t>(text.size()));
  for (const char c : text) writer.number(c);
}

void decode(Reader& reader, std::string& text) {
  text.resize(reader.length(1));
  for (char& c : text) c = reader.number<char>();
}

/// Rows, columns, then (row, column, value) in column order.
void encode(Writer& writer, const Sparse& m) {
  writer.number(static_cast<std::uint64_t>(m.rows()));
  writer.number(static_cast<std::uint64_t>(m.cols()));
  writer.number(static_cast<std::uint64_t>(m.nonZeros()));
  for (Eigen::Index col = 0; col < m.outerSize(); ++col) {
    for (Sparse::InnerIterator entry(m, col); entry; ++entry) {
      writer.number(static_cast<std::int64_t>(entry.row()));
      writer.number(static_cast<std::int64_t>(entry.col()));
      writer.number(entry.value());
    }
  }
}

void decode(Reader& reader, Sparse& m) {
  // A sparse matrix allocates its column starts, so the size is bounded by itself.
  constexpr std::uint64_t largest = 1'000'000;
  constexpr std::size_t entryBytes = 2 * sizeof(std::int64_t) + sizeof(double);
  const auto rows = reader.number<std::uint64_t>();
  const auto cols = reader.number<std::uint64_t>();
  if (rows > largest || cols > largest) throw WireError("a sparse matrix is too large");
  const std::size_t count = reader.length(entryBytes);
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const auto row = reader.number<std::int64_t>();
    const auto col = reader.number<std::int64_t>();
    const double value = reader.number<double>();
    if (row < 0 || col < 0 || static_cast<std::uint64_t>(row) >= rows || static_cast<std::uint64_t>(col) >= cols) {
      throw WireError("an entry lies outside its sparse matrix");
    }
    entries.emplace_back(static_cast<int>(row), static_cast<int>(col), value);
  }
  m.resize(static_cast<Eigen::Index>(rows), static_cast<Eigen::Index>(cols));
  m.setFromTriplets(entries.begin(), entries.end());
}

}  // namespace muelle::grader::wire
