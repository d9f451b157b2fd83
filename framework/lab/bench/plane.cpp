#include "lab/bench/plane.h"

#include <fmt/format.h>
#include <algorithm>

namespace muelle::bench {

namespace {

Statistics over(std::size_t rounds, const std::function<double(std::size_t)>& value) {
  std::vector<double> values;
  for (std::size_t round = 0; round < rounds; ++round) values.push_back(value(round));
  return statisticsOf(values);
}

Best bestAt(const Curve& curve, const Crossing& crossing) {
  Best best{&curve, crossing, {}, evaluationsAt(curve, crossing), crossing.coarse == crossing.fine};
  best.seconds = over(roundsAt(curve, crossing), [&](std::size_t round) { return secondsAt(curve, crossing, round); });
  return best;
}

/// Of what was timed in the rounds when anything was; the least median wins.
std::optional<Best> bestOf(const SceneResult& scene, double target, const std::function<bool(const Curve&)>& counts) {
  std::optional<Best> best;
  for (const Curve& curve : scene.curves) {
    const std::optional<Crossing> crossing = crossingAt(curve, target);
    if (!crossing || !counts(curve)) continue;
    const Best candidate = bestAt(curve, *crossing);
    const bool moreRounds = best && candidate.seconds.count > 1 && best->seconds.count == 1;
    const bool fewerRounds = best && candidate.seconds.count == 1 && best->seconds.count > 1;
    if (!best || moreRounds || (!fewerRounds && candidate.seconds.median < best->seconds.median)) best = candidate;
  }
  return best;
}

double fewestEvaluations(const SceneResult& scene, Row row, double target) {
  double fewest = 0.0;
  for (const Curve& curve : scene.curves) {
    const std::optional<Crossing> crossing = crossingAt(curve, target);
    if (curve.row != row || !crossing) continue;
    const double evaluations = evaluationsAt(curve, *crossing);
    if (fewest == 0.0 || evaluations < fewest) fewest = evaluations;
  }
  return fewest;
}

std::optional<Statistics> ratio(const std::optional<Best>& peer, const std::optional<Best>& ours) {
  if (!peer || !ours) return std::nullopt;
  return over(static_cast<std::size_t>(std::min(peer->seconds.count, ours->seconds.count)), [&](std::size_t round) {
    return secondsAt(*peer->curve, peer->crossing, round) / secondsAt(*ours->curve, ours->crossing, round);
  });
}

Entry entryAt(const SceneResult& scene, double target) {
  Entry entry{.target = target, .allowed = scene.allows(target)};
  if (!entry.allowed) return entry;
  const auto inRow = [](Row row, bool events) {
    return [row, events](const Curve& curve) {
      return curve.row == row && (row == Row::Ours || curve.locatesEvents == events);
    };
  };
  entry.ours = bestOf(scene, target, inRow(Row::Ours, false));
  entry.plain = bestOf(scene, target, inRow(Row::Plain, false));
  entry.kernel = bestOf(scene, target, inRow(Row::Kernel, false));
  entry.plainWithEvents = bestOf(scene, target, inRow(Row::Plain, true));
  entry.toPlain = ratio(entry.plain, entry.ours);
  entry.toKernel = ratio(entry.kernel, entry.ours);
  entry.toPlainWithEvents = ratio(entry.plainWithEvents, entry.ours);
  entry.fewestOurs = fewestEvaluations(scene, Row::Ours, target);
  entry.fewestPlain = fewestEvaluations(scene, Row::Plain, target);
  return entry;
}

}  // namespace

std::vector<Entry> entriesOf(const SceneResult& scene) {
  std::vector<Entry> entries;
  for (const double target : targets) entries.push_back(entryAt(scene, target));
  return entries;
}

std::optional<AgainstNaive> againstNaive(const SceneResult& scene, double target) {
  const Curve* naive = scene.find(naiveEulerKey);
  const std::optional<Best> ours = bestOf(scene, target, [](const Curve& curve) { return curve.row == Row::Ours; });
  if (naive == nullptr || !ours || !scene.allows(target)) return std::nullopt;
  const auto point = std::ranges::find_if(naive->points, [](const CurvePoint& p) { return !p.failed(); });
  if (point == naive->points.end()) return std::nullopt;
  AgainstNaive result{.step = point->setting, .error = point->error.position, .ours = ours->seconds};
  result.naive = statisticsOf(point->seconds);
  result.method = ours->curve->method;
  const auto rounds = static_cast<std::size_t>(std::min(result.ours.count, result.naive.count));
  result.ratio = over(rounds, [&](std::size_t round) {
    return secondsAt(*ours->curve, ours->crossing, round) / point->seconds[round];
  });
  return result;
}

std::vector<std::string> missingCurves(const SceneResult& scene) {
  std::vector<std::string> lines;
  for (const Curve& curve : scene.curves) {
    if (!curve.crash.empty()) {
      lines.push_back(fmt::format("{}: {} crashed: {}", scene.name, curve.key(), curve.crash));
    } else if (curve.points.empty()) {
      lines.push_back(fmt::format("{}: {} has no curve", scene.name, curve.key()));
    }
  }
  for (const Row row : {Row::Ours, Row::Plain, Row::Kernel}) {
    const auto stands = [row](const Curve& curve) { return curve.row == row && curve.hasResult(); };
    if (std::ranges::none_of(scene.curves, stands)) {
      lines.push_back(fmt::format("{}: no run of row {} has reached the end", scene.name, nameOf(row)));
    }
  }
  return lines;
}

}  // namespace muelle::bench
