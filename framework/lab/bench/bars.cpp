#include "lab/bench/bars.h"

#include <fmt/format.h>
#include <algorithm>

namespace muelle::bench {

namespace {

using Verdict = Bar::Verdict;

Verdict verdictOf(bool met) { return met ? Verdict::Met : Verdict::Missed; }

std::string withInterval(const Statistics& s) {
  return fmt::format("{:.2f} ({:.2f} to {:.2f})", s.median, s.low, s.high);
}

/// How much faster than A the scene's kind promises us to be; 0: nothing is promised.
double promisedToPlain(SceneKind kind, double target) {
  switch (kind) {
    case SceneKind::Small:
      return target > 1e-3 ? 1.0 : target > 1e-5 ? 1.5 : 2.5;
    case SceneKind::Grid:
      return 2.0;
    case SceneKind::General:
      return 1.0;
    case SceneKind::Damped:
      return target > 1e-5 ? 2.0 : 0.0;
    case SceneKind::Bounce:
      return target > 1e-3 ? 0.0 : 5.0;
  }
  return 0.0;
}

/// A row without a run that reaches the error cannot be behind or ahead by a number.
Bar ratioBar(const std::string& where, const std::string& promise, double least, const std::optional<Statistics>& ratio,
             const std::optional<Best>& ours, const std::optional<Best>& peer) {
  Bar bar{.where = where, .promise = promise, .measured = {}};
  if (ratio) {
    bar.measured = fmt::format("{}: ours {}, {}", withInterval(*ratio), ours->curve->method, peer->curve->label());
    bar.verdict = verdictOf(ratio->median >= least);
  } else if (ours) {
    bar.measured = fmt::format("in the time of the longest run only ours gets there: {}", ours->curve->method);
    bar.verdict = Verdict::Met;
  } else if (peer) {
    bar.measured = fmt::format("none of ours gets there; {} does", peer->curve->label());
    bar.verdict = Verdict::Missed;
  } else {
    bar.measured = "nobody gets there";
  }
  return bar;
}

Bar kernelBar(const std::string& where, const Entry& entry) {
  const std::string promise = "against B never slower beyond the interval";
  Bar bar = ratioBar(where, promise, 1.0, entry.toKernel, entry.ours, entry.kernel);
  if (entry.toKernel) bar.verdict = verdictOf(entry.toKernel->high >= 1.0);
  return bar;
}

Bar evaluationsBar(const std::string& where, const Entry& entry) {
  Bar bar{.where = where, .promise = "at least 2 times fewer evaluations than A", .measured = {}};
  if (entry.fewestOurs == 0.0 || entry.fewestPlain == 0.0) return bar;
  const double ratio = entry.fewestPlain / entry.fewestOurs;
  bar.measured = fmt::format("{:.2f}: {:.0f} to {:.0f}", ratio, entry.fewestOurs, entry.fewestPlain);
  bar.verdict = verdictOf(ratio >= 2.0);
  return bar;
}

void addEntry(std::vector<Bar>& bars, const SceneResult& scene, const Entry& entry) {
  const std::string where = fmt::format("{}, {:.0e}", scene.name, entry.target);
  const double least = promisedToPlain(scene.kind, entry.target);
  if (!entry.allowed) {
    bars.push_back({where, "an entry of the plane",
                    fmt::format("the reference is good to {:.1e} only", scene.doubt.position), Verdict::NotMeasured});
    return;
  }
  if (least > 0.0) {
    const std::string promise = least == 1.0 ? "not behind A" : fmt::format("at least {:g} times as fast as A", least);
    bars.push_back(ratioBar(where, promise, least, entry.toPlain, entry.ours, entry.plain));
  }
  if (scene.kind == SceneKind::Bounce) {
    bars.push_back(ratioBar(where, "at least 2 times as fast as A with events", 2.0, entry.toPlainWithEvents,
                            entry.ours, entry.plainWithEvents));
  }
  bars.push_back(kernelBar(where, entry));
  if (scene.kind == SceneKind::Small && entry.target < 1e-5) bars.push_back(evaluationsBar(where, entry));
}

void addNaiveBar(std::vector<Bar>& bars, const SceneResult& scene) {
  const double most = scene.name == "cloth_32" ? 0.33 : scene.name == "cloth_32_shuffled" ? 0.5 : 0.0;
  if (most == 0.0) return;
  Bar bar{.where = scene.name + ", 1e-02",
          .promise = fmt::format("at most {} of the naive symplectic Euler's time at its largest stable step", most),
          .measured = {}};
  if (const std::optional<AgainstNaive> against = againstNaive(scene, 1e-2)) {
    bar.measured = fmt::format("{}: ours {} ({:.1f} times real time), naive at {:.2e} s with an error of {:.1e}",
                               withInterval(against->ratio), against->method, scene.duration / against->ours.median,
                               against->step, against->error);
    bar.verdict = verdictOf(against->ratio.median <= most);
  }
  bars.push_back(bar);
}

}  // namespace

std::string nameOf(Verdict verdict) {
  return verdict == Verdict::Met ? "met" : verdict == Verdict::Missed ? "missed" : "not measured";
}

std::vector<Bar> barsOf(const SceneResult& scene) {
  std::vector<Bar> bars;
  for (const Entry& entry : entriesOf(scene)) addEntry(bars, scene, entry);
  addNaiveBar(bars, scene);
  return bars;
}

std::string countOf(const std::vector<Bar>& bars) {
  const auto count = [&bars](Verdict verdict) {
    return std::ranges::count_if(bars, [verdict](const Bar& bar) { return bar.verdict == verdict; });
  };
  return fmt::format("{} of {} bars met, {} missed, {} not measured", count(Verdict::Met), bars.size(),
                     count(Verdict::Missed), count(Verdict::NotMeasured));
}

}  // namespace muelle::bench
