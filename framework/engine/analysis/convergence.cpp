#include "engine/analysis/convergence.h"

#include "base/text/count.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace muelle::engine {

namespace {

void check(std::span<const double> hs, std::span<const double> errors) {
  if (hs.size() != errors.size()) {
    throw std::invalid_argument(
        fmt::format("fitOrder: {} but {}", counted(std::ssize(hs), "step"), counted(std::ssize(errors), "error")));
  }
  for (std::size_t i = 0; i < hs.size(); ++i) {
    if (!(hs[i] > 0.0) || (i > 0 && !(hs[i] < hs[i - 1]))) {
      throw std::invalid_argument(fmt::format("fitOrder: step {} is {}; steps are positive and descend", i, hs[i]));
    }
  }
}

double slope(std::span<const double> hs, std::span<const double> errors) {
  double meanX = 0.0, meanY = 0.0;
  const auto n = static_cast<double>(hs.size());
  for (std::size_t i = 0; i < hs.size(); ++i) {
    meanX += std::log(hs[i]) / n;
    meanY += std::log(errors[i]) / n;
  }
  double xx = 0.0, xy = 0.0;
  for (std::size_t i = 0; i < hs.size(); ++i) {
    const double dx = std::log(hs[i]) - meanX;
    xx += dx * dx;
    xy += dx * (std::log(errors[i]) - meanY);
  }
  return xy / xx;
}

double largestDeviation(std::span<const double> hs, std::span<const double> errors, double order) {
  double largest = 0.0;
  for (std::size_t i = 1; i < hs.size(); ++i) {
    const double local = std::log(errors[i - 1] / errors[i]) / std::log(hs[i - 1] / hs[i]);
    largest = std::max(largest, std::abs(local - order));
  }
  return largest;
}

}  // namespace

OrderFit fitOrder(std::span<const double> hs, std::span<const double> errors, double roundOff) {
  check(hs, errors);
  const auto counts = [&](std::size_t i) { return std::isfinite(errors[i]) && errors[i] > 100.0 * roundOff; };
  OrderFit best;
  for (std::size_t first = 0; first < hs.size(); ++first) {
    for (std::size_t end = first; end < hs.size() && counts(end); ++end) {
      const std::size_t count = end - first + 1;
      if (count < 3 || static_cast<int>(count) < best.count) continue;
      const auto h = hs.subspan(first, count), e = errors.subspan(first, count);
      const double order = slope(h, e), deviation = largestDeviation(h, e, order);
      if (deviation > std::max(0.1, 0.03 * std::abs(order))) continue;
      best = {true, order, static_cast<int>(first), static_cast<int>(count), deviation};
    }
  }
  return best;
}

}  // namespace muelle::engine
