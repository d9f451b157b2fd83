#pragma once
/// \file
/// What a demo includes. A demo simulates a small scene with the student's functions and returns its figures:
///
///     // exercises/spring_1d/demo.cpp
///     #include "spring_1d.h"
///     #include "harness/demo.h"
///
///     MUELLE_DEMO {
///       ... submission::springForce(xa, xb, k, L0) ...
///       return {figure};
///     }
///
/// The student's check draws it with the student's functions; the grader draws it twice, with the submission's and with
/// the reference's, one over the other.

#include "harness/figure.h"
#include "harness/function_system.h"
#include "harness/march.h"
#include "harness/mesh.h"
#include "harness/symplectic_euler.h"

#include <vector>

/// Begins the demo's function: no arguments, returns std::vector<muelle::Figure>.
#define MUELLE_DEMO std::vector<muelle::Figure> muelleDemo()

std::vector<muelle::Figure> muelleDemo();
