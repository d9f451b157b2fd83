// attack: throws and prints markup, formulas, escapes, invalid UTF-8 and NUL; expect: zero points; says: threw an exception
#include "spring_1d.h"

#include <cstdio>
#include <stdexcept>
#include <string>

namespace {
double attack() {
  const std::string text =
      std::string("<script>alert(1)</script>\x1b[2J\x1b]0;owned\x07 =cmd|' /C calc'!A0 `rm` \xff\xfe \xe2\x80\xae") +
      '\0' + "\r\nset terminal; system 'id' </pre></html>]]>";
  std::fwrite(text.data(), 1, text.size(), stdout);
  std::fflush(stdout);
  throw std::runtime_error(text);
}
}  // namespace

double lumpedMass(double, int) { return attack(); }
double springForceOnA(double, double, double, double) { return attack(); }
double springForceOnB(double, double, double, double) { return attack(); }
double hangingAcceleration(double, double, const Attachment&, double) { return attack(); }
double accelerationBetween(double, double, const Attachment&, const Attachment&, double) { return attack(); }
