#include "lab/advise/reference_motion.h"

#include "engine/model/axes.h"
#include "lab/advise/countdown.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace muelle::lab {

using namespace engine;

namespace {

constexpr double finestTolerance = 1e-13;

/// Which methods make the reference, the coarser run first.
struct Sources {
  Setting coarse, fine;
  double factor = 0.05;  ///< from the coarse value to the fine one
};

bool isAble(const Pilots& pilots, const char* id) { return refusalOf(pilots.system(), id).empty(); }

/// Explicit ones first; where they take too long, those that step over fast modes.
std::vector<Sources> sourcesFor(const Pilots& pilots, double tolerance) {
  const double first = std::clamp(tolerance / 100.0, finestTolerance, 1e-4);
  if (!pilots.system().rods().empty()) {
    const double h = pilots.scene().step.value_or(pilots.scene().duration / 1000.0);
    return {{{"rattle", true, std::min(h, pilots.scene().duration / 48.0)}, {"rattle", true, 0.0}, 0.25}};
  }
  std::vector<Sources> all;
  const bool smooth = pilots.scene().model.obstacles.empty();
  if (isAble(pilots, "nystrom8") && smooth) {
    all.push_back({{"dop853", false, first}, {"nystrom8", false, 0.0}, 0.1});
  } else {
    all.push_back({{"dop853", false, first}, {"dop853", false, 0.0}, 0.03});
  }
  if (isAble(pilots, "esdirk4")) all.push_back({{"esdirk4", false, first}, {"esdirk4", false, 0.0}, 0.05});
  return all;
}

class ReferenceSearch {
 public:
  ReferenceSearch(const Pilots& pilots, double tolerance, double seconds)
      : pilots_(pilots), tolerance_(tolerance), clock_(seconds) {}

  ReferenceMotion find() {
    found_.failure = "no method makes a reference";
    const std::vector<Sources> all = sourcesFor(pilots_, tolerance_);
    for (std::size_t i = 0; i < all.size(); ++i) {
      const bool isLast = i + 1 == all.size();
      // So much for a first run: a method that has not come to the end by then is not the one for this scene.
      firstShare_ = isLast ? 1.0 : 0.4;
      attempt(all[i]);
      // Where fine runs differ so do runs of any other method, and where the first came to its end the others are no
      // better.
      if (found_.stands() || found_.disagrees || !firstFailed_) break;
    }
    found_.seconds = spent_;
    return std::move(found_);
  }

 private:
  PilotRun take(const Setting& setting, double share = 1.0) {
    PilotRun run = pilots_.run(setting, {.seconds = std::max(0.0, share * clock_.left()), .isReference = true});
    spent_ += run.seconds;
    return run;
  }

  void attempt(Sources sources) {
    const int mostRounds = sources.coarse.fixed ? 10 : 6;
    lastApart_ = 0.0;
    stays_ = 0;
    PilotRun before = take(sources.coarse, firstShare_);
    firstFailed_ = !before.done();
    for (int round = 0; round < mostRounds; ++round) {
      if (!before.done()) return fail(before);
      if (before.motion.position == 0.0 || before.motion.velocity == 0.0) {
        found_.failure = "nothing moves";
        return;
      }
      sources.fine.value = sources.factor * before.setting.value;
      if (!sources.fine.fixed) sources.fine.value = std::max(sources.fine.value, finestTolerance);
      PilotRun finer = take(sources.fine);
      if (!finer.done()) return fail(finer);
      const double apart = errorIn(distanceOf(before.rows, finer.rows), finer.motion);
      const double doubt = doubtOf(finer, apart);
      const bool isLast = isFinest(finer) || round + 1 == mostRounds;
      if (doubt <= tolerance_ / (isLast ? 8.0 : 50.0)) return settle(before, std::move(finer), doubt);
      if (isFinest(finer) || staysApart(finer, apart)) return disagree(before, std::move(finer), apart);
      lastApart_ = apart;
      if (finer.setting.fixed) {
        before = std::move(finer);
        continue;
      }
      // The next pair is so much finer that it should agree.
      const double shrinks = std::clamp(tolerance_ / 100.0 / apart, 1e-4, 0.1);
      sources.coarse.value = std::max(3.0 * finestTolerance, sources.coarse.value * shrinks);
      before = take(sources.coarse);
    }
    found_.failure = "runs do not come to agree, however fine their steps";
    found_.disagrees = true;
  }

  static bool isFinest(const PilotRun& run) { return !run.setting.fixed && run.setting.value <= finestTolerance; }

  /// What the finer run may be off. A quarter of the step leaves a sixteenth of the error of order 2: where two pairs
  /// in a row show that, an eighth of what they differ by is more than enough.
  double doubtOf(const PilotRun& finer, double apart) const {
    const double shrinks = lastApart_ / apart;
    return finer.setting.fixed && shrinks > 10.0 && shrinks < 25.0 ? apart / 8.0 : apart;
  }

  /// Chaos: differences that hardly shrink. (Steps are a quarter each time, tolerances far less. Steps begin where they
  /// may not resolve anything yet: there it has to be seen three times.)
  bool staysApart(const PilotRun& finer, double apart) {
    const double shrinks = finer.setting.fixed ? 0.7 : 0.3;
    const bool stays = lastApart_ > 0.0 && apart > shrinks * lastApart_ && apart > 10.0 * tolerance_;
    stays_ = stays ? stays_ + 1 : 0;
    return stays_ >= (finer.setting.fixed ? 3 : 1);
  }

  void disagree(const PilotRun& before, PilotRun finer, double apart) {
    found_.failure = fmt::format("{} at {} and {} at {} differ by {:.1g} of the motion", before.setting.method,
                                 before.setting.valueText(), finer.setting.method, finer.setting.valueText(), apart);
    found_.disagrees = true;
    keep(std::move(finer), apart);
  }

  void settle(const PilotRun& before, PilotRun finer, double apart) {
    found_.how = fmt::format("{} at {}, beside {} at {}", finer.setting.name(), finer.setting.valueText(),
                             before.setting.name(), before.setting.valueText());
    found_.failure.clear();
    found_.outOfTime = found_.disagrees = false;
    keep(std::move(finer), apart);
  }
  void keep(PilotRun finer, double apart) {
    found_.run = std::move(finer);
    found_.doubt = apart;
  }
  void fail(const PilotRun& run) {
    found_.outOfTime = run.outOfTime;
    found_.failure =
        run.outOfTime ? fmt::format("{} at {} had come to {:.3g} of {:.3g} s when the time was over",
                                    run.setting.method, run.setting.valueText(), run.reached, pilots_.scene().duration)
                      : fmt::format("{} at {}: {}", run.setting.method, run.setting.valueText(), run.failure);
  }

  const Pilots& pilots_;
  double tolerance_;
  Countdown clock_;
  double firstShare_ = 1.0, spent_ = 0.0;
  double lastApart_ = 0.0;  // of the pair before; 0: none
  int stays_ = 0;           // pairs in a row that did not come nearer
  bool firstFailed_ = false;
  ReferenceMotion found_;
};

}  // namespace

double ReferenceMotion::errorOf(const Pilots& whole, const PathRows& rows) const {
  MotionSize apart;
  const double slack = 1e-11 * whole.scene().duration;
  std::size_t before = 0;  // the last of the reference's states that is not later
  State at = run.states.front();
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const std::size_t known = before;
    while (before + 1 < run.states.size() && run.states[before + 1].t <= rows.t[i] + slack) ++before;
    if (before != known) at = run.states[before];
    if (rows.t[i] > at.t + slack) at = whole.advance(run.setting, at, rows.t[i]);
    PathRows exact;
    exact.add(whole.system(), at);
    apart.include(distanceOf(rows, i, exact, 0));
  }
  return errorIn(apart, run.motion);
}

ReferenceMotion findReference(const Pilots& pilots, double tolerance, double seconds) {
  return ReferenceSearch(pilots, tolerance, seconds).find();
}

double growthOf(const Pilots& pilots, const ReferenceMotion& reference, int axis, double seconds) {
  const ModelSystem& system = pilots.system();
  const Model& model = system.model();
  State start = system.initialState();
  const double offset = 1e-7 * reference.run.motion.position;
  std::mt19937 dice(9);
  double disturbed = 0.0;
  for (int node = 0; node < system.nodeCount(); ++node) {
    if (!isFree(model.nodes[static_cast<std::size_t>(node)])) continue;
    double squares = 0.0;
    for (const int c : engine::axesOf(model)) {
      if (axis >= 0 && c != axis) continue;
      const double part = offset * (static_cast<double>(dice() % 2001) / 1000.0 - 1.0);
      start.x[static_cast<std::size_t>(system.lane(node, c))] += part;
      squares += part * part;
    }
    disturbed = std::max(disturbed, std::sqrt(squares));
  }
  start.z.clear();
  const PilotRun other = pilots.run(reference.run.setting, {.seconds = seconds, .isReference = true, .start = &start});
  if (!other.done()) return std::numeric_limits<double>::infinity();
  return distanceOf(other.rows, reference.run.rows).position / disturbed;
}

}  // namespace muelle::lab
