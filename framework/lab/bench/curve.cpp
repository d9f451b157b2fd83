#include "lab/bench/curve.h"

#include <algorithm>
#include <cmath>

namespace muelle::bench {

namespace {

bool meets(const CurvePoint& point, double target) { return !point.failed() && point.error.position <= target; }

double secondsOfRound(const CurvePoint& point, std::size_t round) {
  return round < point.seconds.size() ? point.seconds[round] : statisticsOf(point.seconds).median;
}

}  // namespace

bool Curve::hasResult() const {
  return std::ranges::any_of(points, [](const CurvePoint& point) { return !point.failed(); });
}

std::optional<Crossing> crossingAt(const Curve& curve, double target) {
  const std::vector<CurvePoint>& points = curve.points;
  if (points.empty() || !meets(points.back(), target)) return std::nullopt;
  std::size_t fine = points.size() - 1;
  while (fine > 0 && meets(points[fine - 1], target)) --fine;
  if (fine == 0 || points[fine - 1].failed()) return Crossing{fine, fine, 0.0};
  const double before = points[fine - 1].error.position, after = std::max(points[fine].error.position, 1e-300);
  return Crossing{fine - 1, fine, std::log(before / target) / std::log(before / after)};
}

double atCrossing(const Crossing& crossing, double coarse, double fine) {
  return std::pow(coarse, 1.0 - crossing.weight) * std::pow(fine, crossing.weight);
}

double secondsAt(const Curve& curve, const Crossing& crossing, std::size_t round) {
  return atCrossing(crossing, secondsOfRound(curve.points[crossing.coarse], round),
                    secondsOfRound(curve.points[crossing.fine], round));
}

double evaluationsAt(const Curve& curve, const Crossing& crossing) {
  const auto count = [&curve](std::size_t i) {
    return static_cast<double>(std::max(1LL, curve.points[i].cost.evaluations));
  };
  return atCrossing(crossing, count(crossing.coarse), count(crossing.fine));
}

std::size_t roundsAt(const Curve& curve, const Crossing& crossing) {
  return std::min(curve.points[crossing.coarse].seconds.size(), curve.points[crossing.fine].seconds.size());
}

}  // namespace muelle::bench
