#pragma once
/// \file
/// Random inputs for tests: reproducible, and different in every test.

#include "harness/types.h"

#include <cstdint>
#include <random>

namespace muelle {

/// The nearest number of three significant digits: one that can be read, pasted and checked on paper.
double threeDigits(double number);
Vec3 threeDigits(const Vec3& vector);

/// A stream of inputs. Two streams of one seed give the same numbers.
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}

  /// Uniform in [low, high).
  double number(double low, double high);
  /// Log-uniform in [low, high), both positive: for stiffnesses, masses, lengths.
  double positive(double low, double high);
  /// As number(), of three significant digits.
  double rounded(double low, double high);
  /// Uniform integer in [low, high].
  int integer(int low, int high);
  /// Each component uniform in [-scale, scale).
  Vec3 vector3(double scale);
  /// A unit vector, uniform on the sphere.
  Vec3 direction();
  /// A unit vector, to the last bit or two, whose components have three digits or fewer; none is zero.
  Vec3 roundedDirection();
  /// A rotation matrix, uniform over rotations.
  Mat3 rotation();

 private:
  double normal();

  std::mt19937_64 engine_;
};

/// The stream of the test that is running, from the seed of the run and the test's name.
Random testRandom();

/// The seed of the run: fixed for the public tests, set by the grader for the hidden ones.
void setTestSeed(std::uint64_t seed);

}  // namespace muelle
