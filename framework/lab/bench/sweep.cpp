#include "lab/bench/sweep.h"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <map>
#include <optional>
#include <random>
#include <set>
#include <stdexcept>
#include <utility>

namespace muelle::bench {

namespace {

constexpr double coarsestTolerance = 0.1, finestTolerance = 1e-12;
constexpr int mostSettings = 45;

std::string exact(double value) { return fmt::format("{:.17g}", value); }

/// One run with its error, one timed: from the record, or made and put there.
CurvePoint measured(Contestant& contestant, double setting, const BenchScene& scene, const Reference& reference,
                    Record& record, const SweepOptions& options) {
  CurvePoint point{.setting = setting, .cost = {}, .error = {}, .seconds = {}};
  const std::string key = fmt::format("{} {} {}", scene.name, contestant.key(), exact(setting));
  if (const Record::Fields* kept = record.find(key)) {
    point.cost = {std::stoll(kept->at(0)), std::stoll(kept->at(1)), std::stoll(kept->at(2)), kept->at(3)};
    point.error = {std::strtod(kept->at(4).c_str(), nullptr), std::strtod(kept->at(5).c_str(), nullptr)};
    point.seconds = {std::strtod(kept->at(6).c_str(), nullptr)};
    return point;
  }
  Path path(scene.duration, scene.samples);
  const double begin = options.now();
  point.cost = contestant.run(setting, &path);
  double seconds = options.now() - begin;
  if (!point.failed()) {
    point.error = reference.errorOf(path);
    if (!std::isfinite(point.error.position)) point.cost.failure = "numbers that are not finite";
  }
  if (!point.failed()) seconds = secondsOf([&] { contestant.run(setting, nullptr); }, options.now, options.leastTimed);
  point.seconds = {seconds};
  record.add(key, {std::to_string(point.cost.evaluations), std::to_string(point.cost.jacobians),
                   std::to_string(point.cost.solves), point.cost.failure, exact(point.error.position),
                   exact(point.error.velocity), exact(seconds)});
  return point;
}

Curve emptyCurve(const Contestant& contestant) {
  Curve curve;
  curve.row = contestant.row();
  curve.library = contestant.library();
  curve.method = contestant.method();
  curve.takesTolerance = contestant.takesTolerance();
  curve.locatesEvents = contestant.locatesEvents();
  return curve;
}

bool isInLecture(const BenchScene& scene, const Curve& curve) {
  return scene.name == lectureScene && curve.row == Row::Ours &&
         std::ranges::find(lectureMethods, curve.method) != std::end(lectureMethods);
}

/// Whether another curve of the row has come to the point's error in a tenth of its time.
bool isHopeless(const CurvePoint& point, Row row, const std::vector<Curve>& others, double factor) {
  for (const Curve& other : others) {
    if (other.row != row) continue;
    for (const CurvePoint& better : other.points) {
      if (!better.failed() && better.error.position <= point.error.position &&
          factor * better.seconds.back() < point.seconds.back()) {
        return true;
      }
    }
  }
  return false;
}

/// Why no finer setting is worth a run; empty when one is.
std::string reasonToEnd(const Curve& curve, const std::vector<Curve>& others, const PathError& doubt, double factor,
                        bool inLecture, const SweepOptions& options) {
  const std::vector<CurvePoint>& points = curve.points;
  const CurvePoint& last = points.back();
  if (std::ssize(points) >= mostSettings) return fmt::format("{} settings", mostSettings);
  if (!last.failed()) {
    const double enough = std::max(3e-9, doubt.position);
    if (last.error.position < enough) return fmt::format("an error below {:.1e}", enough);
    const auto worse = [&points](std::size_t back) {
      const CurvePoint& now = points[points.size() - back];
      const CurvePoint& before = points[points.size() - back - 1];
      return !before.failed() && now.error.position > 0.7 * before.error.position;
    };
    const auto hopeless = [&](const CurvePoint& point) {
      return !inLecture && !point.failed() && isHopeless(point, curve.row, others, options.hopeless);
    };
    if (points.size() > 1 && hopeless(last) && hopeless(points[points.size() - 2])) {
      return fmt::format("others of its row are {:g} times as fast", options.hopeless);
    }
    if (points.size() > 3 && last.error.position < 1e-5 && worse(1) && worse(2)) return "finer gains nothing";
  }
  const double next = last.seconds.back() / (curve.takesTolerance ? std::sqrt(factor) : factor);
  if (next > options.longestRun) return fmt::format("the next run would take {:.0f} s", next);
  return {};
}

/// Between a step that fails and the next finer one that does not, the largest that stands, to a few per cent.
void findLargestStep(Curve& curve, const std::function<double(double)>& whole,
                     const std::function<CurvePoint(double)>& run) {
  for (int halving = 0; halving < 4; ++halving) {
    const auto first = std::ranges::find_if(curve.points, [](const CurvePoint& point) { return !point.failed(); });
    if (first == curve.points.end() || first == curve.points.begin()) return;
    const double between = whole(std::sqrt(first->setting * (first - 1)->setting));
    if (between < 1.01 * first->setting || between > 0.99 * (first - 1)->setting) return;
    curve.points.insert(first, run(between));
  }
}

Curve curveOf(Contestant& contestant, const BenchScene& scene, const Reference& reference, Record& record,
              const std::vector<Curve>& others, const SweepOptions& options) {
  Curve curve = emptyCurve(contestant);
  const auto whole = [&scene](double h) { return scene.duration / static_cast<double>(scene.stepsOf(h)); };
  const auto run = [&](double setting) { return measured(contestant, setting, scene, reference, record, options); };
  try {
    double setting = curve.takesTolerance ? coarsestTolerance : scene.duration / 10.0;
    while (curve.ended.empty()) {
      if (!curve.takesTolerance) setting = whole(setting);
      curve.points.push_back(run(setting));
      // Until a step stands, halves: they fail soon.
      const double factor = curve.takesTolerance ? options.toleranceFactor
                            : curve.hasResult()  ? options.stepFactor
                                                 : 0.5;
      curve.ended = reasonToEnd(curve, others, reference.doubt(), factor, isInLecture(scene, curve), options);
      const double before = setting;
      setting *= factor;
      while (!curve.takesTolerance && whole(setting) > 0.999 * before) setting *= factor;
      if (curve.takesTolerance && setting < finestTolerance && curve.ended.empty())
        curve.ended = "the finest tolerance";
    }
    if (!curve.takesTolerance) findLargestStep(curve, whole, run);
  } catch (const std::exception& problem) {
    curve.crash = problem.what();
  }
  return curve;
}

/// A point that competes for an entry: curve and index.
using Place = std::pair<std::size_t, std::size_t>;

/// The points around the crossings of those that come near to the best of their row, for every target. Peers that find
/// the contacts and those that step across them are rows of their own.
std::set<Place> competitors(const SceneResult& result, double closeness) {
  std::set<Place> places;
  for (const double target : targets) {
    if (!result.allows(target)) continue;
    std::map<std::pair<Row, bool>, double> best;
    const auto rowOfCurve = [](const Curve& curve) { return std::pair(curve.row, curve.locatesEvents); };
    for (const bool choosing : {false, true}) {
      for (std::size_t c = 0; c < result.curves.size(); ++c) {
        const Curve& curve = result.curves[c];
        const std::optional<Crossing> crossing = crossingAt(curve, target);
        if (!crossing) continue;
        const double seconds = secondsAt(curve, *crossing, 0);
        const auto place = best.try_emplace(rowOfCurve(curve), seconds).first;
        if (!choosing) {
          place->second = std::min(place->second, seconds);
        } else if (seconds <= closeness * place->second) {
          places.insert({c, crossing->coarse});
          places.insert({c, crossing->fine});
        }
      }
    }
  }
  return places;
}

/// The largest stable step of the plain symplectic Euler competes, too: a bar is read on it.
void addNaive(const SceneResult& result, std::set<Place>& places) {
  for (std::size_t c = 0; c < result.curves.size(); ++c) {
    const Curve& curve = result.curves[c];
    if (curve.key() != naiveEulerKey) continue;
    const auto first = std::ranges::find_if(curve.points, [](const CurvePoint& point) { return !point.failed(); });
    if (first != curve.points.end()) places.insert({c, static_cast<std::size_t>(first - curve.points.begin())});
  }
}

void addLecture(const SceneResult& result, const BenchScene& scene, std::set<Place>& places) {
  for (std::size_t c = 0; c < result.curves.size(); ++c) {
    const Curve& curve = result.curves[c];
    if (!isInLecture(scene, curve)) continue;
    for (std::size_t i = 0; i < curve.points.size(); ++i) {
      if (!curve.points[i].failed()) places.insert({c, i});
    }
  }
}

int roundsIn(const SceneResult& result, const std::set<Place>& places, const SweepOptions& options) {
  double once = 0.0;
  for (const auto& [c, i] : places) {
    once += std::max(options.leastTimed, result.curves[c].points[i].seconds.front());
  }
  if (once == 0.0) return options.rounds;
  const int affordable = static_cast<int>(std::min(1e6, options.secondsOfRounds / once));
  return std::clamp(affordable, std::min(5, options.rounds), options.rounds);
}

double timedRound(Contestant& contestant, const CurvePoint& point, const std::string& key, Record& record,
                  const SweepOptions& options) {
  if (const Record::Fields* kept = record.find(key)) return std::strtod(kept->at(0).c_str(), nullptr);
  const double seconds = secondsOf([&] { contestant.run(point.setting, nullptr); }, options.now, options.leastTimed);
  record.add(key, {exact(seconds)});
  return seconds;
}

/// Every competitor once a round, in an order drawn anew each time.
void runRounds(SceneResult& result, const BenchScene& scene, const Contestants& contestants, Record& record,
               const SweepOptions& options, double share) {
  std::set<Place> places = competitors(result, options.closeness);
  addNaive(result, places);
  addLecture(result, scene, places);
  result.rounds = roundsIn(result, places, options);
  std::vector<Place> order(places.begin(), places.end());
  std::mt19937 dice(1);
  for (const auto& [c, i] : order) result.curves[c].points[i].seconds.clear();
  for (int round = 0; round < result.rounds; ++round) {
    for (std::size_t i = order.size(); i-- > 1;) std::swap(order[i], order[dice() % (i + 1)]);
    for (const auto& [c, i] : order) {
      CurvePoint& point = result.curves[c].points[i];
      const std::string key =
          fmt::format("{} {} {} round {}", scene.name, contestants[c]->key(), exact(point.setting), round);
      point.seconds.push_back(timedRound(*contestants[c], point, key, record, options));
    }
    options.progress(1.0 - share + share * (round + 1) / result.rounds);
  }
}

/// Nothing where the run fails.
std::optional<PathError> errorOfArbiter(Contestant& contestant, double tolerance, const BenchScene& scene,
                                        const Reference& reference, Record& record) {
  const std::string key = fmt::format("{} arbiter {} {}", scene.name, contestant.key(), exact(tolerance));
  if (const Record::Fields* kept = record.find(key)) {
    if (!kept->at(0).empty()) return std::nullopt;
    return PathError{std::strtod(kept->at(1).c_str(), nullptr), std::strtod(kept->at(2).c_str(), nullptr)};
  }
  Path path(scene.duration, scene.samples);
  const RunCost cost = contestant.run(tolerance, &path);
  const PathError error = cost.failure.empty() ? reference.errorOf(path) : PathError{};
  record.add(key, {cost.failure, exact(error.position), exact(error.velocity)});
  return cost.failure.empty() ? std::optional(error) : std::nullopt;
}

/// Processes that want a processor, on average over the last minute.
double load() {
  std::array<double, 1> average{};
  return getloadavg(average.data(), 1) == 1 ? average[0] : 0.0;
}

}  // namespace

const Curve* SceneResult::find(const std::string& key) const {
  const auto place = std::ranges::find_if(curves, [&key](const Curve& curve) { return curve.key() == key; });
  return place == curves.end() ? nullptr : &*place;
}

SceneResult sweep(const BenchScene& scene, const Contestants& contestants, const Reference& reference, Record& record,
                  const SweepOptions& options) {
  SceneResult result{.name = scene.name, .title = scene.title, .kind = scene.kind};
  result.unknowns = unknownsOf(scene.model);
  result.springs = static_cast<int>(scene.model.springs.size());
  result.duration = scene.duration;
  result.doubt = reference.doubt();
  result.arbiter = reference.arbiter();
  constexpr double shareOfRounds = 0.4;
  double done = 0.0;
  for (const auto& contestant : contestants) {
    result.curves.push_back(curveOf(*contestant, scene, reference, record, result.curves, options));
    options.progress((1.0 - shareOfRounds) * ++done / static_cast<double>(contestants.size()));
  }
  const double before = load();
  runRounds(result, scene, contestants, record, options, shareOfRounds);
  result.busy = std::max(0.0, 0.5 * (before + load()) - 1.0);
  return result;
}

void judge(Reference& reference, const BenchScene& scene, const Contestants& contestants, Record& record) {
  bool judged = false;
  for (const auto& contestant : contestants) {
    // The most exact of what a user has: tolerances near round-off, whichever serves best.
    for (const double tolerance : {1e-11, 1e-13}) {
      if (!contestant->mayJudge()) continue;
      const std::optional<PathError> error = errorOfArbiter(*contestant, tolerance, scene, reference, record);
      if (!error || (judged && error->position >= reference.doubt().position)) continue;
      judged = true;
      reference.judgeBy(fmt::format("{} {} at {:.0e}", contestant->library(), contestant->method(), tolerance), *error);
    }
  }
  if (!judged) throw std::runtime_error(scene.name + ": no second source for the reference: no peer reached the end");
}

}  // namespace muelle::bench
