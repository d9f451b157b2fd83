#include "base/text/count.h"
#include "lab/bench/report.h"

#include <fmt/format.h>

namespace muelle::bench {

namespace {

std::string bestText(const std::optional<Best>& best) {
  if (!best) return "-";
  return fmt::format("{}{} ({:.0f}) {}", timeText(best->seconds.median), best->better ? "*" : "", best->evaluations,
                     best->curve->row == Row::Ours ? best->curve->method : best->curve->label());
}

std::string ratioText(const std::optional<Statistics>& ratio) {
  return ratio ? fmt::format("{:.2f} ({:.2f} .. {:.2f})", ratio->median, ratio->low, ratio->high) : "-";
}

}  // namespace

std::string timeText(double seconds) {
  if (seconds < 1e-3) return fmt::format("{:.3g} us", 1e6 * seconds);
  if (seconds < 1.0) return fmt::format("{:.3g} ms", 1e3 * seconds);
  return fmt::format("{:.3g} s", seconds);
}

std::string tableText(const SceneResult& scene) {
  std::string text = fmt::format(
      "{}: {}, {:.3g} s; {}, {}\n  reference good to {:.1e} in x, {:.1e} in v ({}); small errors grow {:.3g} times\n",
      scene.name, scene.title, scene.duration, counted(scene.unknowns, "unknown"), counted(scene.springs, "spring"),
      scene.doubt.position, scene.doubt.velocity, scene.arbiter, scene.amplification);
  for (const Entry& entry : entriesOf(scene)) {
    if (!entry.allowed) {
      text += fmt::format("  {:.0e}  no entry: the reference is not a hundred times better\n", entry.target);
      continue;
    }
    text += fmt::format("  {:.0e}  ours {:<44} A {:<44} B {}\n", entry.target, bestText(entry.ours),
                        bestText(entry.plain), bestText(entry.kernel));
    text += fmt::format("         A / ours {:<26} B / ours {}", ratioText(entry.toPlain), ratioText(entry.toKernel));
    if (entry.plainWithEvents) {
      text += fmt::format("   A with events {}, / ours {}", bestText(entry.plainWithEvents),
                          ratioText(entry.toPlainWithEvents));
    }
    text += "\n";
  }
  return text;
}

std::string barsText(const std::vector<Bar>& bars) {
  std::string text = "Bars\n";
  for (const Bar& bar : bars) {
    text += fmt::format("  {:<13} {:<24} {}: {}\n", nameOf(bar.verdict), bar.where, bar.promise,
                        bar.measured.empty() ? "-" : bar.measured);
  }
  return text + "  " + countOf(bars) + "\n";
}

}  // namespace muelle::bench
