#include "lab/bench/contestant.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace muelle::bench {

std::string nameOf(Row row) { return row == Row::Ours ? "ours" : row == Row::Plain ? "A" : "B"; }

Row rowOf(const std::string& name) {
  for (const Row row : {Row::Ours, Row::Plain, Row::Kernel}) {
    if (nameOf(row) == name) return row;
  }
  throw std::invalid_argument("no row '" + name + "'; there are ours, A and B");
}

long long stepsFor(double duration, double h) {
  // A step that divides the duration but for rounding is not cut into one more.
  return std::max(1LL, static_cast<long long>(std::ceil(duration / h * (1.0 - 1e-12))));
}

}  // namespace muelle::bench
