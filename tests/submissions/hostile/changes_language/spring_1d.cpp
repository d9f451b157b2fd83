// attack: prints with a decimal comma; expect: zero points
#include "spring_1d.h"

#include <iostream>
#include <locale>

double lumpedMass(double M, int n) {
  std::cout.imbue(std::locale("es_ES.UTF-8"));
  std::cout << M / n << '\n';
  return 0;
}
double springForceOnA(double, double, double, double) { return 0; }
double springForceOnB(double, double, double, double) { return 0; }
double hangingAcceleration(double, double, const Attachment&, double) { return 0; }
double accelerationBetween(double, double, const Attachment&, const Attachment&, double) { return 0; }
