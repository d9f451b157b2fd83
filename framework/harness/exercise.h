#pragma once
/// \file
/// What a contract header includes: the types, and the line that names the functions of the exercise.
///
///     // exercises/spring_3d/spring_3d.h
///     #include "harness/exercise.h"
///     using muelle::Vec3;
///     Vec3 springForce(const Vec3& xa, const Vec3& xb, double k, double L0);
///     MUELLE_FUNCTIONS(springForce)
///
/// In a student's file both macros below expand to nothing. A test program names, in MUELLE_FUNCTIONS_HEADER, a header
/// that gives them a meaning: call the functions directly, call them in another process, or serve such calls.

#include "harness/types.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <span>
#include <string>
#include <vector>

#ifdef MUELLE_FUNCTIONS_HEADER
#include MUELLE_FUNCTIONS_HEADER
#else
/// Names the functions of the exercise, all in the global namespace and none overloaded.
#define MUELLE_FUNCTIONS(...)
/// Names the fields of a struct that the functions take or return: MUELLE_STRUCT(Spring, a, b, k, L0).
/// Must stand before MUELLE_FUNCTIONS.
#define MUELLE_STRUCT(Type, ...)
#endif

/// States what may be passed for a parameter, a struct's field, or the length of a list of that name: from the least to
/// the most, both included. For a reader, and for the tests of the tests, which see to it that both ends are passed;
/// the compiler sees nothing of it.
#define MUELLE_RANGE(name, least, most)
