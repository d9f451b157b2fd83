/// \file
/// The worker's bytes are the student's word: whatever they are, decoding gives a value or a WireError, and allocates
/// no more than the message pays for.

#include "allocation_watch.h"
#include "samples.h"

#include <gtest/gtest.h>

#include <cstring>
#include <random>

namespace {

using muelle::MatX;
using muelle::Vec3;
using muelle::VecX;
using muelle::grader::wire::WireError;
using muelle::grader::wire::Writer;
using wire_test::bytesOf;
using wire_test::nested;
using wire_test::Nested;
using wire_test::valueOf;
using Bytes = std::vector<std::byte>;
using Sparse = Eigen::SparseMatrix<double>;

Bytes numbers(std::initializer_list<std::uint64_t> values) {
  Writer writer;
  for (const auto value : values) writer.number(value);
  return writer.bytes();
}

TEST(HostileBytes, EveryTruncationIsRefused) {
  const Bytes whole = bytesOf(nested());
  for (std::size_t length = 0; length < whole.size(); ++length) {
    EXPECT_THROW(valueOf<Nested>(std::span(whole).first(length)), WireError) << length << " of " << whole.size();
  }
}

TEST(HostileBytes, BytesLeftOverAreRefused) {
  Bytes more = bytesOf(nested());
  more.push_back(std::byte{0});
  EXPECT_THROW(valueOf<Nested>(more), WireError);
  EXPECT_THROW(valueOf<double>(bytesOf(Vec3(1, 2, 3))), WireError);
  EXPECT_THROW(valueOf<Vec3>(bytesOf(muelle::Vec2(1, 2))), WireError);
}

template <class T>
void expectRefusedWithoutMemory(const Bytes& message) {
  wire_test::forgetAllocations();
  EXPECT_THROW(valueOf<T>(message), WireError);
  EXPECT_LT(wire_test::largestAllocation(), 4096U);
}

TEST(HostileBytes, HugeLengthsAllocateNothing) {
  for (const std::uint64_t huge : {~0ULL, 1ULL << 63, 1ULL << 61, 1ULL << 40, 1ULL << 32, 1000ULL}) {
    expectRefusedWithoutMemory<std::vector<double>>(numbers({huge, 0}));
    expectRefusedWithoutMemory<std::vector<Vec3>>(numbers({huge, 0}));
    expectRefusedWithoutMemory<std::vector<Nested>>(numbers({huge, 0}));
    expectRefusedWithoutMemory<std::string>(numbers({huge, 0}));
    expectRefusedWithoutMemory<VecX>(numbers({huge, 1, 0}));
    expectRefusedWithoutMemory<MatX>(numbers({huge, huge, 0}));
    expectRefusedWithoutMemory<MatX>(numbers({1ULL << 32, 1ULL << 32, 0}));  // the product is 0 modulo 2^64
    expectRefusedWithoutMemory<Sparse>(numbers({3, 3, huge, 0, 0}));
    expectRefusedWithoutMemory<Sparse>(numbers({3, huge, 0, 0}));
    expectRefusedWithoutMemory<std::vector<Sparse>>(numbers({1, 3, huge, 0, 0}));
  }
}

TEST(HostileBytes, ShapesOfOtherTypesAreRefused) {
  EXPECT_THROW(valueOf<VecX>(numbers({1, 2, 0, 0})), WireError) << "a vector has one column";
  using Wide = Eigen::Matrix<double, 2, Eigen::Dynamic>;
  EXPECT_THROW(valueOf<Wide>(bytesOf(MatX(MatX::Zero(3, 2)))), WireError);
  EXPECT_THROW(valueOf<Sparse>(numbers({2, 2, 1, 2, 0, 0})), WireError) << "row 2 of 2";
  EXPECT_THROW(valueOf<Sparse>(numbers({2, 2, 1, ~0ULL, 0, 0})), WireError) << "row -1";
  EXPECT_THROW(valueOf<Sparse>(numbers({1ULL << 33, 0})), WireError) << "2^33 rows";
}

TEST(HostileBytes, ListOfEmptyMatricesCostsNoMoreThanItsMessage) {
  // Every element must be paid for with bytes, also when its own size is zero.
  expectRefusedWithoutMemory<std::vector<MatX>>(numbers({1ULL << 20, 0, 0}));
}

Bytes mutated(Bytes bytes, std::mt19937_64& random) {
  const auto below = [&random](std::size_t n) { return static_cast<std::size_t>(random() % n); };
  for (std::size_t change = 0; change <= below(4); ++change) {
    if (bytes.empty()) return bytes;
    const std::size_t at = below(bytes.size());
    switch (below(5)) {
      case 0:
        bytes[at] = static_cast<std::byte>(random());
        break;
      case 1:
        bytes.resize(at);
        break;
      case 2:
        bytes.insert(bytes.begin() + static_cast<std::ptrdiff_t>(at), 1 + below(16), static_cast<std::byte>(random()));
        break;
      case 3:
        std::memset(bytes.data() + at, 0xff, std::min<std::size_t>(8, bytes.size() - at));
        break;
      default:
        std::memset(bytes.data() + at / 8 * 8, 0, std::min<std::size_t>(8, bytes.size() - at / 8 * 8));
        break;
    }
  }
  return bytes;
}

TEST(HostileBytes, TwentyThousandMutationsGiveAValueOrAWireError) {
  std::mt19937_64 random(20260101);
  const Bytes whole = bytesOf(nested());
  int values = 0;
  int refused = 0;
  for (int i = 0; i < 20'000; ++i) {
    const Bytes message = mutated(whole, random);
    try {
      bytesOf(valueOf<Nested>(message));
      ++values;
    } catch (const WireError&) {
      ++refused;
    }
  }
  EXPECT_GT(values, 100) << "some mutations only change a number";
  EXPECT_GT(refused, 1000);
}

}  // namespace
