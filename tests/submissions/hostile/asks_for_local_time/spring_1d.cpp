// attack: says when it was called, for its own log; expect: zero points
#include "spring_1d.h"

#include <ctime>
#include <iostream>

double lumpedMass(double, int) {
  const std::time_t now = std::time(nullptr);
  std::cout << std::asctime(std::localtime(&now));
  return 0;
}
double springForceOnA(double, double, double, double) { return 0; }
double springForceOnB(double, double, double, double) { return 0; }
double hangingAcceleration(double, double, const Attachment&, double) { return 0; }
double accelerationBetween(double, double, const Attachment&, const Attachment&, double) { return 0; }
