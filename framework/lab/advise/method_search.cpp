#include "lab/advise/method_search.h"

#include "lab/advise/countdown.h"
#include "lab/bench/report.h"
#include "lab/bench/statistics.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <optional>

namespace muelle::lab {

using namespace engine;

namespace {

/// A method is not begun when it is foreseen to take so many times the best, for estimates are rough; nor at a setting
/// that is known to take so many times the best.
constexpr double roughly = 8.0, surely = 1.5;

/// Three digits, no larger: for whoever reads it.
double readable(double value) {
  const double unit = std::pow(10.0, std::floor(std::log10(value)) - 2.0);
  const double digits = std::floor(value / unit * (1.0 + 1e-12));
  return unit < 1.0 ? digits / std::round(1.0 / unit) : digits * unit;
}

/// Searches one method's setting.
class SettingSearch {
 public:
  SettingSearch(const Pilots& pilots, const Pilots& whole, const ReferenceMotion& reference, double allowed,
                Candidate& candidate)
      : pilots_(pilots), whole_(whole), reference_(reference), allowed_(allowed), candidate_(candidate) {}

  /// \param best  seconds of the cheapest so far   \param left  tells the seconds that are left
  void run(double best, const std::function<double()>& left) {
    const MethodEstimate& estimate = candidate_.estimate;
    double value = estimate.setting.value;
    constexpr int mostRuns = 8;
    for (int i = 0; i < mostRuns; ++i) {
      value = readable(value);
      if (left() <= 0.0) return stop(true, "the time was over");
      const PilotRun run = timed({estimate.setting.method, estimate.setting.fixed, value},
                                 {.seconds = left(), .ofProcessor = std::max(0.02, 3.0 * best)});
      ++candidate_.runs;
      if (run.outOfTime) return stop(left() <= 0.0, fmt::format("{} takes too long", run.setting.valueText()));
      const std::optional<double> next = judge(run, value);
      if (!next) return;
      const double foreseen = foreseenSeconds(*next);
      if (!candidate_.keeps() && foreseen > surely * best) {
        return stop(false, fmt::format("at {} it would take {}", text(*next), bench::timeText(foreseen)));
      }
      value = *next;
    }
    stop(false, "no setting was found that keeps the tolerance");
  }
  bool outOfTime() const { return outOfTime_; }

 private:
  struct Tried {
    double value = 0.0, error = 0.0, seconds = 0.0;
    bool failed = false;
  };

  std::string text(double value) const {
    return Setting{candidate_.estimate.setting.method, candidate_.estimate.setting.fixed, value}.valueText();
  }
  bool fixed() const { return candidate_.estimate.setting.fixed; }

  /// A run that is over in less than a millisecond is timed as the least of three: one interruption is as long as that,
  /// and would have a good method given up.
  PilotRun timed(const Setting& setting, const PilotLimits& limits) const {
    constexpr double brief = 1e-3;
    PilotRun run = pilots_.run(setting, limits);
    for (int again = 0; again < 2 && run.done() && run.seconds < brief; ++again) {
      run.seconds = std::min(run.seconds, pilots_.run(setting, limits).seconds);
    }
    return run;
  }

  /// The setting to try next; nothing where the search is at its end.
  std::optional<double> judge(const PilotRun& run, double asked) {
    Tried tried{asked, 0.0, run.seconds, !run.done()};
    if (run.done()) {
      const double found = reference_.errorOf(whole_, run.rows);
      tried.error = statedError(found, reference_.doubt);
      if (!std::isfinite(tried.error)) tried.failed = true;
      if (!tried.failed) candidate_.points.push_back({found, run.seconds});
    }
    if (!tried.failed) seeOrder(tried);
    last_ = tried;
    if (tried.failed) {
      coarsestBad_ = std::min(coarsestBad_, asked);
      reason_ = run.failure;
      return kept_ ? std::nullopt
                   : std::optional(asked * (!fixed()                                        ? 0.1
                                            : asked > 0.8 * candidate_.estimate.largestStep ? 0.9
                                                                                            : 0.6));
    }
    if (tried.error <= allowed_) {
      keep(run, tried);
      return coarser(tried);
    }
    coarsestBad_ = std::min(coarsestBad_, asked);
    reason_ = fmt::format("at {} its error is {:.2g}", run.setting.valueText(), tried.error);
    if (kept_) return between(tried);
    candidate_.setting = run.setting;
    candidate_.error = tried.error;
    candidate_.seconds = run.seconds;
    candidate_.fate = Candidate::Fate::Missed;
    candidate_.why = reason_;
    return finer(tried);
  }

  void keep(const PilotRun& run, const Tried& tried) {
    // A finer setting may be faster by accident: fewer steps are rejected.
    if (kept_ && tried.seconds > 1.2 * kept_->seconds) return;
    kept_ = tried;
    candidate_.setting = run.setting;
    candidate_.error = tried.error;
    candidate_.seconds = run.seconds;
    candidate_.fate = Candidate::Fate::Keeps;
    candidate_.why.clear();
  }

  /// By how much the error shrinks with the setting: from the last two runs, else as the method says.
  void seeOrder(const Tried& now) {
    if (last_ && !last_->failed && now.error > 0.0 && last_->error > 0.0 && last_->value != now.value) {
      const double seen = std::log(last_->error / now.error) / std::log(last_->value / now.value);
      if (fixed() && seen > 0.3) candidate_.orderSeen = seen;
      if (seen > 0.3) power_ = std::clamp(seen, 0.4, fixed() ? candidate_.estimate.order + 1.0 : 1.5);
    }
  }
  double power() const { return power_ > 0.0 ? power_ : fixed() ? candidate_.estimate.order : 0.9; }

  std::optional<double> finer(const Tried& tried) const {
    // Of an error as large as the motion nothing can be told: linear theory has a better guess.
    const double guess = 2.0 * candidate_.estimate.stepForError;
    if (fixed() && tried.error > 0.5 && guess < 0.5 * tried.value) return guess;
    const double factor = std::pow(0.88 * allowed_ / tried.error, 1.0 / power());
    const double next = tried.value * std::clamp(factor, fixed() ? 0.02 : 1e-4, 0.9);
    if (!fixed() && next < 2e-14) return std::nullopt;
    return next;
  }
  /// Only where it pays: a fifth of the cost, and there is room.
  std::optional<double> coarser(const Tried& tried) const {
    const double limit = fixed() ? candidate_.estimate.largestStep : 1.0;
    const double room = std::pow(0.93 * allowed_ / tried.error, 1.0 / power());
    double next = std::min({tried.value * std::min(room, fixed() ? 4.0 : 30.0), limit, 0.93 * coarsestBad_});
    if (!pays(next)) return std::nullopt;
    return next;
  }
  /// Between a setting that keeps the tolerance and a coarser one that does not, where that still pays.
  std::optional<double> between(const Tried& coarse) {
    constexpr int most = 2;
    if (coarse.value <= kept_->value || ++betweens_ > most || !(kept_->error > 0.0)) return std::nullopt;
    const double way = std::log(0.85 * allowed_ / kept_->error) / std::log(coarse.error / kept_->error);
    const double next = kept_->value * std::pow(coarse.value / kept_->value, std::clamp(way, 0.0, 0.9));
    return pays(next) ? std::optional(next) : std::nullopt;
  }
  /// Whether a coarser setting saves a ninth of the cost or more.
  bool pays(double coarser) const {
    const double ratio = coarser / kept_->value;
    return (fixed() ? ratio : std::pow(ratio, 1.0 / (candidate_.estimate.order + 1.0))) >= 1.12;
  }
  double foreseenSeconds(double value) const {
    if (!last_) return 0.0;
    const double finer = last_->value / value;
    return last_->seconds * (fixed() ? finer : std::pow(finer, 1.0 / (candidate_.estimate.order + 1.0)));
  }
  void stop(bool outOfTime, std::string why) {
    outOfTime_ = outOfTime;
    if (candidate_.keeps()) return;
    candidate_.why = reason_.empty() ? std::move(why) : reason_ + "; " + why;
    if (candidate_.runs > 0 && candidate_.fate == Candidate::Fate::NotRun) candidate_.fate = Candidate::Fate::Missed;
  }

  const Pilots& pilots_;
  const Pilots& whole_;
  const ReferenceMotion& reference_;
  double allowed_;
  Candidate& candidate_;
  std::optional<Tried> last_, kept_;
  double coarsestBad_ = std::numeric_limits<double>::infinity();
  double power_ = 0.0;
  int betweens_ = 0;
  std::string reason_;
  bool outOfTime_ = false;
};

/// Where no search came to an end: the reference itself keeps the tolerance.
void takeReference(MethodChoice& choice, const ReferenceMotion& reference) {
  const Setting& setting = reference.run.setting;
  for (Candidate& candidate : choice.candidates) {
    if (candidate.estimate.setting.method != setting.method || candidate.estimate.setting.fixed != setting.fixed)
      continue;
    candidate.fate = Candidate::Fate::Keeps;
    candidate.setting = setting;
    candidate.error = statedError(reference.doubt, reference.doubt);
    candidate.seconds = reference.run.seconds;
    candidate.runs += 1;
    candidate.why = "what the others were held against";
  }
}

/// Times those that are close to the cheapest in turn, without looks, and takes the median of each.
void timeSideBySide(const Pilots& pilots, std::vector<Candidate*> close, const std::function<double()>& left) {
  constexpr int rounds = 7;
  constexpr std::size_t most = 5;
  std::ranges::sort(close, {}, &Candidate::seconds);
  if (close.size() > most) close.resize(most);
  std::vector<std::vector<double>> times(close.size());
  for (int round = 0; round < rounds && left() > 0.0; ++round) {
    for (std::size_t i = 0; i < close.size(); ++i) {
      times[i].push_back(pilots.bareSeconds(close[i]->setting));
    }
  }
  for (std::size_t i = 0; i < close.size(); ++i) {
    if (times[i].empty()) continue;
    const double median = bench::statisticsOf(times[i]).median, ratio = median / close[i]->seconds;
    close[i]->seconds = median;
    for (TriedPoint& point : close[i]->points) point.seconds *= ratio;
  }
}

/// Looks at the cheapest again, at as many times as there are. Where it is off by more than is allowed its setting is
/// made finer, and where that does not help it is left.
bool isVerified(const Pilots& pilots, const Pilots& whole, const ReferenceMotion& reference, double tolerance,
                Candidate& candidate) {
  constexpr int mostRuns = 4;
  double lastSeconds = 0.0;
  // The point that this setting had is told anew.
  std::erase_if(candidate.points, [&](const TriedPoint& point) {
    return std::abs(point.seconds - candidate.seconds) < 1e-6 * candidate.seconds;
  });
  for (int i = 0; i < mostRuns; ++i) {
    const PilotRun run = pilots.run(candidate.setting, {.looksOften = true});
    ++candidate.runs;
    if (!run.done()) break;
    candidate.setting = run.setting;
    const double found = reference.errorOf(whole, run.rows);
    const double error = statedError(found, reference.doubt);
    // Looks take time of their own, alike in these runs.
    if (lastSeconds > 0.0) candidate.seconds *= run.seconds / lastSeconds;
    lastSeconds = run.seconds;
    candidate.points.push_back({found, candidate.seconds});
    candidate.error = error;
    if (error <= tolerance) return true;
    const double power = candidate.setting.fixed ? candidate.estimate.order : 1.0;
    candidate.setting.value = readable(candidate.setting.value * std::pow(0.8 * tolerance / error, 1.0 / power));
  }
  candidate.fate = Candidate::Fate::Missed;
  candidate.why = fmt::format("looked at more often its error is {:.2g}", candidate.error);
  return false;
}

const auto rankOf = [](const Candidate& c) { return c.keeps() ? 0 : c.fate == Candidate::Fate::Unfit ? 2 : 1; };

void sortByTime(std::vector<Candidate>& candidates) {
  std::ranges::stable_sort(candidates, [](const Candidate& a, const Candidate& b) {
    return rankOf(a) != rankOf(b) ? rankOf(a) < rankOf(b) : a.seconds < b.seconds;
  });
}

}  // namespace

double statedError(double found, double doubt) { return std::max(statedLeast, statedFactor * (found + doubt)); }

const Candidate* MethodChoice::chosen() const {
  return !candidates.empty() && candidates.front().fate == Candidate::Fate::Chosen ? &candidates.front() : nullptr;
}

MethodChoice chooseMethod(const Pilots& pilots, const Pilots& whole, const ReferenceMotion& reference,
                          const std::vector<MethodEstimate>& estimates, double tolerance, double seconds,
                          const std::function<void(double)>& progress) {
  const Countdown clock(seconds);
  const auto left = [&] { return clock.left() - 0.15 * seconds; };
  MethodChoice choice;
  // The reference's own run keeps the tolerance: nothing slower is of use.
  double best = reference.run.seconds;
  for (std::size_t i = 0; i < estimates.size(); ++i) {
    Candidate& candidate = choice.candidates.emplace_back();
    candidate.estimate = estimates[i];
    candidate.setting = estimates[i].setting;
    candidate.seconds = estimates[i].seconds;
    if (!estimates[i].fits()) {
      candidate.fate = Candidate::Fate::Unfit;
      candidate.why = estimates[i].refusal;
    } else if (estimates[i].leastSeconds > surely * best) {
      candidate.why = "at its largest step, too, it is slower";
    } else if (estimates[i].seconds > roughly * best) {
      candidate.why = "foreseen to be slower";
    } else if (left() <= 0.0) {
      candidate.why = "the time was over";
      choice.outOfTime = true;
    } else {
      SettingSearch search(pilots, whole, reference, tolerance, candidate);
      search.run(best, left);
      choice.outOfTime = choice.outOfTime || search.outOfTime();
      if (candidate.keeps()) best = std::min(best, candidate.seconds);
    }
    progress(static_cast<double>(i + 1) / static_cast<double>(estimates.size()));
  }
  if (std::ranges::none_of(choice.candidates, &Candidate::keeps)) takeReference(choice, reference);
  std::vector<Candidate*> close;
  for (Candidate& candidate : choice.candidates) {
    if (candidate.keeps() && candidate.seconds <= 2.0 * best) close.push_back(&candidate);
  }
  timeSideBySide(pilots, close, [&] { return clock.left(); });
  sortByTime(choice.candidates);
  while (!choice.candidates.empty() && choice.candidates.front().keeps()) {
    Candidate& cheapest = choice.candidates.front();
    const double before = cheapest.seconds;
    if (isVerified(pilots, whole, reference, tolerance, cheapest) && cheapest.seconds <= 1.05 * before) break;
    const std::string name = cheapest.setting.name();
    sortByTime(choice.candidates);
    if (choice.candidates.front().keeps() && choice.candidates.front().setting.name() == name) break;
  }
  if (!choice.candidates.empty() && choice.candidates.front().keeps()) {
    choice.candidates.front().fate = Candidate::Fate::Chosen;
  }
  choice.seconds = clock.passed();
  return choice;
}

}  // namespace muelle::lab
