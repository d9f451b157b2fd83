#pragma once
/// \file
/// Motions under a student's forces: what is wrong is told by time and node.

#include "harness/trajectory.h"

#include <gtest/gtest.h>

namespace muelle::grader {

/// For MUELLE_EXPECT_WENT_ON: fails with the line of the stop report.
::testing::AssertionResult wentOn(const char* text, const Trajectory& trajectory);

/// Expects nodes in 3D at the places, and with the velocities, of the reference. Tells the first time that is off, and
/// whether a motion stopped before its end.
/// \param tolerance [m] and [m/s]
void expectSameMotion(const Trajectory& trajectory, const Trajectory& reference, double tolerance);

}  // namespace muelle::grader

#define MUELLE_EXPECT_WENT_ON(trajectory) EXPECT_PRED_FORMAT1(::muelle::grader::wentOn, trajectory)
