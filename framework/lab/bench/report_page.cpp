#include "base/text/count.h"
#include "lab/bench/report.h"

#include <fmt/format.h>

namespace muelle::bench {

namespace {

std::string cell(const std::optional<Best>& best) {
  if (!best) return "–";
  return fmt::format("{} {}{} ({:.0f})", best->curve->row == Row::Ours ? best->curve->method : best->curve->label(),
                     timeText(best->seconds.median), best->better ? "*" : "", best->evaluations);
}

std::string cell(const std::optional<Statistics>& ratio) {
  return ratio ? fmt::format("**{:.2f}** ({:.2f} – {:.2f})", ratio->median, ratio->low, ratio->high) : "–";
}

std::string head(const Machine& machine, const std::vector<std::string>& versions, const std::string& note) {
  std::string text =
      "# Speed against error\n\n"
      "The page is made by `./muelle bench --keep`. Every number is of one machine and one run:\n\n";
  text += fmt::format("- {}, {}, {} core{}, {}, {}\n", machine.processor, machine.instructionSet, machine.cores,
                      machine.cores == 1 ? "" : "s", machine.system, machine.date);
  text += fmt::format("- {}, {}\n- peers:", machine.compiler, machine.flags);
  for (const std::string& version : versions) text += " " + version + (&version == &versions.back() ? "\n" : ",");
  return text + "- " + note + "\n\n";
}

constexpr const char* howToRead =
    "Row A is the best of the peers on a plain loop over the springs, as its user writes it; row B the best of the "
    "peers\n"
    "on the engine's force. An error is e_x over the whole run: the largest difference of a node at any time, in parts "
    "of\n"
    "the largest motion. A time is the processor's, from preparing the method to the end of the run, at the very "
    "error:\n"
    "straight in logarithms between the two settings around it, and at the coarsest that stands (marked \\*) where "
    "that is\n"
    "better already. It is the median of runs made in turn; ratios are taken turn by turn, with the interval in which\n"
    "their median lies (95 %). In brackets evaluations of the force. A curve counts from where it stays below an "
    "error,\n"
    "so that luck earns nothing. There is no entry where a hundred times the reference's error is above the "
    "target.\n\n";

std::string sceneSection(const SceneResult& scene) {
  std::string text = fmt::format(
      "## {}\n\n`{}`: {:.3g} s, {}, {}. The reference agrees with {} to {:.1e} (velocities {:.1e}); small errors of "
      "the start "
      "grow "
      "{:.3g} times. {} of what competes{}.\n\n![{}](speed/{}.png)\n\n",
      scene.title, scene.name, scene.duration, counted(scene.unknowns, "unknown"), counted(scene.springs, "spring"),
      scene.arbiter, scene.doubt.position, scene.doubt.velocity, scene.amplification, counted(scene.rounds, "round"),
      scene.busy > 0.3 ? fmt::format("; {:.1f} other processes wanted a processor", scene.busy) : "", scene.title,
      scene.name);
  text += "| error | ours | A | B | A / ours | B / ours |\n|---|---|---|---|---|---|\n";
  for (const Entry& e : entriesOf(scene)) {
    if (!e.allowed) {
      text += fmt::format("| {:.0e} | no entry | | | | |\n", e.target);
      continue;
    }
    text += fmt::format("| {:.0e} | {} | {} | {} | {} | {} |\n", e.target, cell(e.ours), cell(e.plain), cell(e.kernel),
                        cell(e.toPlain), cell(e.toKernel));
    if (e.plainWithEvents) {
      text += fmt::format("| {:.0e}, events | | {} | | {} | |\n", e.target, cell(e.plainWithEvents),
                          cell(e.toPlainWithEvents));
    }
  }
  for (const std::string& line : scene.left) text += fmt::format("\nNot run: {}.\n", line);
  return text + "\n";
}

}  // namespace

std::string page(const std::vector<SceneResult>& scenes, const std::vector<Bar>& bars, const Machine& machine,
                 const std::vector<std::string>& versions, const std::string& note, const std::string& more) {
  std::string text = head(machine, versions, note) + howToRead;
  text += "## Bars\n\n" + countOf(bars) + ".\n\n| where | promised | measured | |\n|---|---|---|---|\n";
  for (const Bar& bar : bars) {
    text += fmt::format("| {} | {} | {} | {} |\n", bar.where, bar.promise, bar.measured.empty() ? "–" : bar.measured,
                        bar.verdict == Bar::Verdict::Missed ? "**missed**" : nameOf(bar.verdict));
  }
  text += "\n";
  for (const SceneResult& scene : scenes) text += sceneSection(scene);
  return text + more;
}

}  // namespace muelle::bench
