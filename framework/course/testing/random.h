#pragma once
/// \file
/// Random inputs for tests: reproducible, and different in every test.

#include "harness/types.h"

#include <cstdint>
#include <random>

namespace muelle {

/// A stream of inputs. Two streams of one seed give the same numbers.
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}

  /// Uniform in [low, high).
  double number(double low, double high);
  /// Log-uniform in [low, high), both positive: for stiffnesses, masses, lengths.
  double positive(double low, double high);
  /// Uniform integer in [low, high].
  int integer(int low, int high);
  /// Each component uniform in [-scale, scale).
  Vec3 vector3(double scale);
  /// A unit vector, uniform on the sphere.
  Vec3 direction();
  /// A rotation matrix, uniform over rotations.
  Mat3 rotation();

  /// The number to three significant digits: what a student is shown can be typed. 0.71938 gives 0.719.
  static double rounded(double number);

 private:
  double normal();

  std::mt19937_64 engine_;
};

/// The stream of the test that is running, from the seed of the run and the test's name.
Random testRandom();

/// The seed of the run: fixed for the public tests, set by the grader for the hidden ones.
void setTestSeed(std::uint64_t seed);

}  // namespace muelle
