#include "course/check/plain_types.h"

#include <gtest/gtest.h>

namespace muelle {
namespace {

TEST(PlainTypes, NamesTheCoursesVectors) {
  EXPECT_EQ(withPlainTypes("'const muelle::Vec3' {aka 'const Eigen::Matrix<double, 3, 1>'}"), "'const Vec3'");
  EXPECT_EQ(withPlainTypes("'Eigen::Matrix<double, 3, 1>'"), "'Vec3'");
  EXPECT_EQ(withPlainTypes("'Eigen::Matrix<double, -1, -1>'"), "'MatX'");
  EXPECT_EQ(withPlainTypes("'Eigen::Matrix<float, 3, 1>'"), "'Eigen::Vector3f'");
  EXPECT_EQ(withPlainTypes("'Eigen::Vector3d'"), "'Vec3'");
}

TEST(PlainTypes, HidesTemplateExpressions) {
  EXPECT_EQ(withPlainTypes("'const Eigen::CwiseBinaryOp<Eigen::internal::scalar_sum_op<double, double>, "
                           "const Eigen::Matrix<double, 3, 1>, const Eigen::Matrix<double, 3, 1> >' to 'double'"),
            "'Eigen expression' to 'double'");
  EXPECT_EQ(withPlainTypes("'Eigen::DenseBase<Eigen::Matrix<double, 3, 1> >::ConstantReturnType'"),
            "'Eigen expression'");
}

TEST(PlainTypes, LeavesOtherTextAlone) { EXPECT_EQ(withPlainTypes("a < b > c {x}"), "a < b > c {x}"); }

TEST(PlainTypes, FindsTheMatricesThatATextMentions) {
  EXPECT_EQ(
      matrixNamesIn(
          "Dst = Eigen::Matrix<double, 2, 1>; Src = X<Eigen::Matrix<double, 3, 1>, Eigen::Matrix<double, 3, 1> >"),
      (std::vector<std::string>{"Vec2", "Vec3"}));
}

TEST(PlainTypes, SurvivesBrokenText) {
  EXPECT_EQ(withPlainTypes("Eigen::Matrix<double"), "Eigen matrix");
  EXPECT_EQ(withPlainTypes("x {aka 'never closed"), "x");
}

}  // namespace
}  // namespace muelle
