#pragma once
#include <string>
#include <vector>

namespace scenes {

/// What a method has come to with one length of its steps, on a public scene.
struct Point {
  int steps;         ///< or, where steps are chosen by an estimate of the error, how many digits it is asked for
  long evaluations;  ///< of the force; one of the Hessian counts as ten
  double error;      ///< [m]
};

struct Curve {
  std::string name;
  std::vector<Point> points;
};

// tests/challenge/frontier_test.cpp computes every number again, and prints the table if one has changed.

inline const std::vector<Curve> rabbitFrontier = {};
inline const std::vector<Curve> clothFrontier = {};
inline const std::vector<Curve> ballFrontier = {};

}  // namespace scenes
