/// \file
/// The assertions come from Eigen itself, so that a new version that words them otherwise is noticed.

#include "course/check/eigen_message.h"

#include "harness/types.h"

#include <gtest/gtest.h>
#include <functional>
#include <stdexcept>

namespace muelle {

/// This program's own answer: the sentence as an exception.
void eigenAssertionFailed(const char* condition, const char* function, AssertedIndex index) {
  throw std::runtime_error(eigenMessage(condition, function, index, "springForce"));
}

namespace {

/// What a student reads when the operation is refused.
std::string said(const std::function<void()>& operation) {
  try {
    operation();
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "accepted";
}

volatile double sink = 0;
volatile int three = 3;

TEST(EigenMessage, NamesTheIndexAndTheVector) {
  Vec3 v = Vec3::Zero();
  EXPECT_EQ(said([&] { sink = v[three]; }), "index 3 of a 3-vector in springForce");
  EXPECT_EQ(said([&] { v(-1) = 1; }), "index -1 of a 3-vector in springForce");
  VecX x = VecX::Zero(2);
  EXPECT_EQ(said([&] { sink = x[2]; }), "index 2 of a vector in springForce");
  EXPECT_EQ(said([&] { sink = (v + v)[three]; }), "index 3 of an expression in springForce");
}

TEST(EigenMessage, NamesTheMatrix) {
  Mat3 m = Mat3::Zero();
  EXPECT_EQ(said([&] { sink = m(3, 0); }), "row or column out of range of a 3 x 3 matrix in springForce");
}

TEST(EigenMessage, SaysThatSizesDiffer) {
  const VecX a = VecX::Zero(2);
  const VecX b = VecX::Zero(3);
  const std::string message = "vectors or matrices of different sizes are added, subtracted or assigned in springForce";
  EXPECT_EQ(said([&] { VecX sum = a + b; }), message);
  EXPECT_EQ(said([&] {
              VecX c = b;
              c += a;
            }),
            message);
  EXPECT_EQ(said([&] { sink = a.dot(b); }), "dot product of vectors of different sizes in springForce");
}

TEST(EigenMessage, SaysThatAProductDoesNotFit) {
  const MatX m = MatX::Zero(2, 2);
  const VecX v = VecX::Zero(3);
  EXPECT_EQ(said([&] { VecX p = m * v; }),
            "product of a matrix and a vector or matrix whose sizes do not fit in springForce");
}

TEST(EigenMessage, SaysThatABlockIsOutside) {
  VecX v = VecX::Zero(6);
  const std::string message = "block, segment, row or column outside of the vector or matrix in springForce";
  EXPECT_EQ(said([&] { sink = v.segment<3>(4).sum(); }), message);
  EXPECT_EQ(said([&] { sink = v.segment(4, 3).sum(); }), message);
}

TEST(EigenMessage, CountsWhatFollowsACommaInitializer) {
  // Eigen asserts these in a destructor too, where a test cannot catch them.
  const char* function = "Eigen::CommaInitializer<MatrixType>::finished()";
  EXPECT_EQ(eigenMessage("m_col == m_xpr.cols() && \"Too few coefficients passed to comma initializer (operator<<)\"",
                         function, {}, "springForce"),
            "too few numbers after << for the size of the vector or matrix in springForce");
  EXPECT_EQ(eigenMessage("m_row<m_xpr.rows() && \"Too many rows passed to comma initializer (operator<<)\"", function,
                         {}, "springForce"),
            "too many numbers after << for the size of the vector or matrix in springForce");
}

double thrown() { throw std::runtime_error("no spring has index 7"); }

TEST(EigenMessage, LeavesAnExceptionThatIsOnItsWay) {
  Vec3 v;
  EXPECT_EQ(said([&] { v << 1, thrown(); }), "no spring has index 7");
  EXPECT_EQ(said([&] { v << 1, v[three], thrown(); }), "index 3 of a 3-vector in springForce");
}

TEST(EigenMessage, RefusesToResizeAFixedVector) {
  EXPECT_EQ(
      said([] {
        Vec3 v;
        v = VecX::Zero(2);
      }),
      "wrong number of components for a vector or matrix of fixed size (a Vec3 takes three numbers) in springForce");
}

TEST(EigenMessage, QuotesWhatItDoesNotKnow) {
  EXPECT_EQ(eigenMessage("a == b", "void f()", {}, ""), "Eigen refused an operation: 'a == b' does not hold");
}

}  // namespace
}  // namespace muelle
