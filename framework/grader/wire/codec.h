#pragma once
/// \file
/// Values as bytes and back: numbers, vectors and matrices of fixed and of run-time size, sparse matrices, lists and
/// structs. `encode(writer, value)` and `decode(reader, value)`; decode throws WireError and allocates nothing that the
/// message does not pay for.
///
/// Headers alone, which each half compiles with its own flags: the worker's fills Eigen's matrices with NaN and has no
/// sanitizers, and an object made for one half would bring its copies of Eigen's functions into the other.

#include "course/testing/struct_fields.h"
#include "grader/wire/bytes.h"
#include "harness/types.h"

#include <Eigen/SparseCore>

#include <array>
#include <string>
#include <vector>

namespace muelle::grader::wire {

using Sparse = Eigen::SparseMatrix<double>;

template <class T>
concept Number = std::is_arithmetic_v<T>;

// Declared first, so that lists of structs of matrices of ... find each other.
template <Number T>
void encode(Writer& writer, T value);
template <Number T>
void decode(Reader& reader, T& value);
inline void encode(Writer& writer, const std::string& text);
inline void decode(Reader& reader, std::string& text);
template <int Rows, int Cols, int Options>
void encode(Writer& writer, const Eigen::Matrix<double, Rows, Cols, Options>& m);
template <int Rows, int Cols, int Options>
void decode(Reader& reader, Eigen::Matrix<double, Rows, Cols, Options>& m);
inline void encode(Writer& writer, const Sparse& m);
inline void decode(Reader& reader, Sparse& m);
template <class T>
void encode(Writer& writer, const std::vector<T>& list);
template <class T>
void decode(Reader& reader, std::vector<T>& list);
template <class T, std::size_t N>
void encode(Writer& writer, const std::array<T, N>& list);
template <class T, std::size_t N>
void decode(Reader& reader, std::array<T, N>& list);
template <DescribedStruct T>
void encode(Writer& writer, const T& object);
template <DescribedStruct T>
void decode(Reader& reader, T& object);

template <Number T>
void encode(Writer& writer, T value) {
  if constexpr (std::is_floating_point_v<T>) {
    writer.number(static_cast<double>(value));
  } else {
    writer.number(static_cast<std::int64_t>(value));
  }
}

template <Number T>
void decode(Reader& reader, T& value) {
  if constexpr (std::is_floating_point_v<T>) {
    value = static_cast<T>(reader.number<double>());
  } else {
    const auto wide = reader.number<std::int64_t>();
    value = static_cast<T>(wide);
    if (static_cast<std::int64_t>(value) != wide) throw WireError("an integer is out of range");
  }
}

inline void encode(Writer& writer, const std::string& text) {
  writer.number(static_cast<std::uint64_t>(text.size()));
  for (const char c : text) writer.number(c);
}

inline void decode(Reader& reader, std::string& text) {
  text.resize(reader.length(1));
  for (char& c : text) c = reader.number<char>();
}

/// A matrix whose size is known travels as its entries alone; otherwise rows and columns come first.
template <int Rows, int Cols, int Options>
void encode(Writer& writer, const Eigen::Matrix<double, Rows, Cols, Options>& m) {
  if constexpr (Rows == Eigen::Dynamic || Cols == Eigen::Dynamic) {
    writer.number(static_cast<std::uint64_t>(m.rows()));
    writer.number(static_cast<std::uint64_t>(m.cols()));
  }
  writer.numbers(m.data(), static_cast<std::size_t>(m.size()));
}

template <int Rows, int Cols, int Options>
void decode(Reader& reader, Eigen::Matrix<double, Rows, Cols, Options>& m) {
  if constexpr (Rows == Eigen::Dynamic || Cols == Eigen::Dynamic) {
    const auto rows = reader.number<std::uint64_t>();
    const auto cols = reader.number<std::uint64_t>();
    const std::size_t room = reader.remaining() / sizeof(double);
    constexpr std::uint64_t longestSide = 1UL << 30;  // of an empty matrix, whose entries bound nothing
    if (rows > longestSide || cols > longestSide || (cols > 0 && rows > room / cols)) {
      throw WireError("a matrix is larger than its message");
    }
    const auto fits = [](int known, std::uint64_t given) {
      return known == Eigen::Dynamic || given == static_cast<std::uint64_t>(known);
    };
    if (!fits(Rows, rows) || !fits(Cols, cols)) {
      throw WireError("a matrix has the wrong shape");
    }
    m.resize(static_cast<Eigen::Index>(rows), static_cast<Eigen::Index>(cols));
  }
  reader.numbers(m.data(), static_cast<std::size_t>(m.size()));
}

/// Rows, columns, then for each column the number of its entries and (row, value) of each: a column takes more bytes in
/// the message than its start takes in memory.
inline void encode(Writer& writer, const Sparse& m) {
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

inline void decode(Reader& reader, Sparse& m) {
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

template <class T>
void encode(Writer& writer, const std::vector<T>& list) {
  writer.number(static_cast<std::uint64_t>(list.size()));
  for (const auto& item : list) encode(writer, static_cast<const T&>(item));
}

template <class T>
void decode(Reader& reader, std::vector<T>& list) {
  // Every element but an empty struct takes at least eight bytes; memory grows only as they are read.
  const std::size_t count = reader.length(sizeof(std::int64_t));
  list.clear();
  for (std::size_t i = 0; i < count; ++i) {
    T item{};
    decode(reader, item);
    list.push_back(std::move(item));
  }
}

template <class T, std::size_t N>
void encode(Writer& writer, const std::array<T, N>& list) {
  for (const auto& item : list) encode(writer, item);
}

template <class T, std::size_t N>
void decode(Reader& reader, std::array<T, N>& list) {
  for (auto& item : list) decode(reader, item);
}

template <DescribedStruct T>
void encode(Writer& writer, const T& object) {
  visitFields(object, [&writer](const auto& field) { encode(writer, field); });
}

template <DescribedStruct T>
void decode(Reader& reader, T& object) {
  visitFields(object, [&reader](auto& field) { decode(reader, field); });
}

}  // namespace muelle::grader::wire
