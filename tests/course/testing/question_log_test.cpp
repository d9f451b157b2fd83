#include "course/testing/question_log.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace {

using muelle::QuestionLog;
using muelle::TestFunction;

const std::function<double(double)> root = [](double x) {
  if (x < 0) throw std::domain_error("no root");
  return std::sqrt(x);
};

TEST(QuestionLog, HoldsQuestionsAndAnswersInTheirOrder) {
  const QuestionLog log;
  const std::function<double(double)> asked = log.kept("root", "std::sqrt", root);
  const std::function<int(int, int)> sum = log.kept("sum", "std::plus", std::function<int(int, int)>(std::plus<int>()));
  EXPECT_EQ(log.text(), "");
  EXPECT_EQ(asked(4), 2);
  EXPECT_EQ(sum(1, 2), 3);
  EXPECT_EQ(log.count(), 2);
  EXPECT_EQ(log.text(), "root(4) is 2, sum(1, 2) is 3");
}

TEST(QuestionLog, SaysWhatThrew) {
  const QuestionLog log;
  const std::function<double(double)> asked = log.kept("root", "std::sqrt", root);
  EXPECT_THROW(asked(-1), std::domain_error);
  EXPECT_EQ(log.text(), "root(-1) throws");
}

TEST(QuestionLog, CountsAllAndShowsTheFirst) {
  const QuestionLog log;
  const std::function<double(double)> asked = log.kept("root", "std::sqrt", root);
  for (int i = 0; i < 100; ++i) asked(1);
  EXPECT_EQ(log.count(), 100);
  EXPECT_TRUE(log.text().ends_with("root(1) is 1 and 94 more")) << log.text();
}

TEST(QuestionLog, IsShownByItsSource) {
  EXPECT_EQ(
      muelle::printCall("derivative", std::function<double(double)>(QuestionLog().kept("root", "std::sqrt", root))),
      "derivative(std::sqrt)");
}

}  // namespace
