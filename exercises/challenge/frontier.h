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

inline const std::vector<Curve> rabbitFrontier = {
    {"explicit Euler", {{1000, 1000, 1.19e-04}, {3000, 3000, 3.96e-05}}},
    {"velocity Verlet", {{100, 101, 7.97e-06}, {300, 301, 8.86e-07}, {1000, 1001, 7.97e-08}, {3000, 3001, 8.80e-09}}},
    {"Runge-Kutta 4",
     {{40, 160, 4.42e-06}, {60, 240, 7.90e-07}, {80, 320, 2.32e-07}, {110, 440, 5.98e-08}, {160, 640, 1.21e-08}}},
    {"Nyström 4",
     {{40, 120, 1.76e-06}, {60, 180, 3.10e-07}, {80, 240, 9.13e-08}, {120, 360, 1.65e-08}, {160, 480, 4.80e-09}}},
};
inline const std::vector<Curve> clothFrontier = {
    {"velocity Verlet", {{5000, 5001, 4.58e-08}, {7000, 7001, 2.57e-08}, {10000, 10001, 1.29e-08}}},
    {"backward Euler", {{50, 550, 4.80e-02}, {200, 2200, 2.98e-03}, {800, 8800, 4.07e-04}}},
    {"Rosenbrock 2", {{100, 1200, 8.82e-03}, {200, 2400, 9.32e-04}, {400, 4800, 6.90e-05}}},
    {"implicit midpoint",
     {{70, 770, 2.58e-05}, {80, 880, 1.56e-05}, {120, 1320, 4.69e-06}, {240, 2640, 9.98e-07}, {480, 5280, 4.78e-07}}},
};
inline const std::vector<Curve> ballFrontier = {
    {"explicit Euler", {{10000, 10000, 1.24e+00}, {40000, 40000, 1.90e-01}}},
    {"velocity Verlet",
     {{4000, 4001, 9.73e-03}, {8000, 8001, 3.43e-03}, {16000, 16001, 1.06e-03}, {32000, 32001, 2.60e-04}}},
    {"Runge-Kutta 4", {{2000, 8000, 5.21e-03}, {4000, 16000, 1.90e-04}, {8000, 32000, 2.41e-05}}},
    {"Dormand-Prince 5, steps by estimate",
     {{5, 787, 3.85e-03}, {6, 1033, 5.69e-04}, {7, 1303, 1.29e-04}, {8, 1843, 1.69e-05}, {9, 2425, 4.63e-07}}},
};

}  // namespace scenes
