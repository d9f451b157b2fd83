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

/// Rows, columns, then for each column the number of its entries and (row, value) of each: a column takes more bytes in
/// the message than its start takes in memory.
void encode(Writer& writer, const Sparse& m) {
  writer.number(static_cast<std::uint64_t>(m.rows()));
  writer.number(static_cast<std::uint64_t>(m.cols()));
  for (Eigen::Index col = 0; col < m.outerSize(); ++col) {
    std::uint64_t count = 0;
    for (Sparse::InnerIterator entry(m, col); entry; ++entry) ++count;
    writer.number(count);
    for (Sparse::InnerIterator entry(m, col); entry; ++entry) {
      writer.number(static_cast<std::int64_t>(entry.row()));
      writer.number(entry.value());
    }
  }
}

void decode(Reader& reader, Sparse& m) {
  constexpr std::uint64_t mostRows = 1'000'000;  // no answer is larger, and whoever multiplies by it allocates that
  const auto rows = reader.number<std::uint64_t>();
  const std::size_t cols = reader.length(sizeof(std::uint64_t));
  if (rows > mostRows) throw WireError("a sparse matrix is too large");
  m.resize(static_cast<Eigen::Index>(rows), static_cast<Eigen::Index>(cols));
  for (std::size_t col = 0; col < cols; ++col) {
    m.startVec(static_cast<Eigen::Index>(col));
    const std::size_t count = reader.length(sizeof(std::uint64_t) + sizeof(double));
    std::uint64_t next = 0;  // rows ascend, so that no entry comes twice
    for (std::size_t i = 0; i < count; ++i) {
      const auto row = reader.number<std::uint64_t>();
      const auto value = reader.number<double>();
      if (row < next || row >= rows) throw WireError("an entry lies outside its sparse matrix");
      m.insertBack(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(col)) = value;
      next = row + 1;
    }
  }
  m.finalize();
}

}  // namespace muelle::grader::wire
