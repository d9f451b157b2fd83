#include "grader/remote/numbers.h"

#include <cmath>

namespace muelle::grader {

void appendNumbers(std::vector<double>& list, const wire::Sparse& m) {
  constexpr double mostEntries = 1e6;
  if (static_cast<double>(m.rows()) * static_cast<double>(m.cols()) <= mostEntries) return appendNumbers(list, MatX(m));
  list.push_back(static_cast<double>(m.rows()));
  list.push_back(static_cast<double>(m.cols()));
}

bool agree(const std::vector<double>& a, const std::vector<double>& b, double floor) {
  if (a.size() != b.size()) return false;
  const double tolerance = 1e-6 * std::max(scaleOf(a), scaleOf(b)) + floor;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (std::isnan(a[i]) != std::isnan(b[i])) return false;
    if (std::isnan(a[i]) || a[i] == b[i]) continue;
    if (!(std::abs(a[i] - b[i]) <= tolerance)) return false;
  }
  return true;
}

double scaleOf(const std::vector<double>& list) {
  double scale = 0;
  for (const double value : list) {
    if (std::isfinite(value)) scale = std::max(scale, std::abs(value));
  }
  return scale;
}

}  // namespace muelle::grader
