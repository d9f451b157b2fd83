/// \file
/// Every figure of the lecture as data, without gnuplot: for the sanitizers.

#include "figure_list.h"

#include <gtest/gtest.h>

namespace muelle::plots {
namespace {

class EveryFigure : public ::testing::TestWithParam<LectureFigure> {};

TEST_P(EveryFigure, IsComputed) {
  const Figure figure = GetParam().draw();
  EXPECT_EQ(figure.id(), GetParam().name);
}

INSTANTIATE_TEST_SUITE_P(Lecture, EveryFigure, ::testing::ValuesIn(lectureFigures()),
                         [](const auto& figure) { return figure.param.name; });

}  // namespace
}  // namespace muelle::plots
