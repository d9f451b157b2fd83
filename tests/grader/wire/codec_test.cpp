#include "samples.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>

namespace {

using muelle::MatX;
using muelle::Vec3;
using muelle::VecX;
using wire_test::bytesOf;
using wire_test::nested;
using wire_test::Nested;
using wire_test::sample;
using wire_test::Sample;
using wire_test::valueOf;

/// Equal bytes are equal values, NaN and the sign of zero included.
template <class T>
void expectReturns(const T& value) {
  const auto bytes = bytesOf(value);
  EXPECT_EQ(bytesOf(valueOf<T>(bytes)), bytes);
}

TEST(RoundTrip, NumbersKeepEveryBit) {
  using Limits = std::numeric_limits<double>;
  for (const double value :
       {0.0, -0.0, 1.0 / 3, Limits::infinity(), -Limits::infinity(), Limits::quiet_NaN(), -std::nan("7"),
        Limits::denorm_min(), Limits::max(), Limits::lowest(), Limits::epsilon()}) {
    EXPECT_EQ(std::bit_cast<std::uint64_t>(valueOf<double>(bytesOf(value))), std::bit_cast<std::uint64_t>(value))
        << value;
  }
  for (const int value : {0, -1, std::numeric_limits<int>::max(), std::numeric_limits<int>::min()}) {
    EXPECT_EQ(valueOf<int>(bytesOf(value)), value);
  }
  EXPECT_TRUE(valueOf<bool>(bytesOf(true)));
  EXPECT_FALSE(valueOf<bool>(bytesOf(false)));
}

TEST(RoundTrip, FixedVectorsAndMatrices) {
  EXPECT_EQ(valueOf<Vec3>(bytesOf(Vec3(1, -2, 3e-300))), Vec3(1, -2, 3e-300));
  const Eigen::Matrix<double, 2, 3> m{{1, 2, 3}, {4, 5, 6}};
  EXPECT_EQ((valueOf<Eigen::Matrix<double, 2, 3>>(bytesOf(m))), m);
  EXPECT_EQ(bytesOf(m).size(), 6 * sizeof(double)) << "a known size does not travel";
  const Eigen::Matrix<double, 2, 2, Eigen::RowMajor> rows{{1, 2}, {3, 4}};
  EXPECT_EQ((valueOf<Eigen::Matrix<double, 2, 2, Eigen::RowMajor>>(bytesOf(rows))), rows);
}

TEST(RoundTrip, DynamicVectorsAndMatricesKeepTheirShape) {
  for (const int n : {0, 1, 5}) {
    EXPECT_EQ(valueOf<VecX>(bytesOf(VecX(VecX::Random(n)))).size(), n);
    const MatX m = MatX::Random(n, 3);
    EXPECT_EQ(valueOf<MatX>(bytesOf(m)), m);
  }
  const MatX flat(0, 7);
  EXPECT_EQ(valueOf<MatX>(bytesOf(flat)).cols(), 7);
}

TEST(RoundTrip, SparseMatrices) {
  const auto m = nested().matrix;
  const auto back = valueOf<Eigen::SparseMatrix<double>>(bytesOf(m));
  EXPECT_EQ(back.rows(), 3);
  EXPECT_EQ(back.cols(), 4);
  EXPECT_EQ(back.nonZeros(), 2);
  EXPECT_EQ(MatX(back), MatX(m));
  expectReturns(Eigen::SparseMatrix<double>(0, 0));
  expectReturns(Eigen::SparseMatrix<double>(5, 5));
}

TEST(RoundTrip, StructsListsAndWhatTheyHold) {
  const Sample back = valueOf<Sample>(bytesOf(sample(3)));
  EXPECT_EQ(back.count, -3);
  EXPECT_TRUE(back.closed);
  EXPECT_EQ(back.nodes.size(), 3U);
  EXPECT_EQ(back.nodes[2], Vec3(2, 2, 2));
  EXPECT_EQ(back.range[1], 5e-324);
  expectReturns(sample(0));
  expectReturns(nested());
  expectReturns(std::vector<std::vector<double>>{{}, {1}, {2, 3}});
  expectReturns(std::vector<bool>{true, false, true});
  expectReturns(std::vector<Nested>(2));
  expectReturns(std::string("spring \xff\0 text", 14));
}

TEST(RoundTrip, IntegersOutOfRangeAreRefused) {
  EXPECT_THROW(valueOf<int>(bytesOf(std::int64_t{1} << 40)), muelle::grader::wire::WireError);
  EXPECT_THROW(valueOf<bool>(bytesOf(2)), muelle::grader::wire::WireError);
}

}  // namespace
