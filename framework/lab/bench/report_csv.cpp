#include "base/text/csv.h"
#include "lab/bench/report.h"

#include <fmt/format.h>

namespace muelle::bench {

namespace {

std::string bestFields(const std::optional<Best>& best) {
  if (!best) return ",,,,";
  return fmt::format("{},{:.6g},{:.6g},{:.6g},{:.0f}", best->curve->key(), best->seconds.median, best->seconds.low,
                     best->seconds.high, best->evaluations);
}

std::string ratioFields(const std::optional<Statistics>& ratio) {
  return ratio ? fmt::format("{:.4g},{:.4g},{:.4g}", ratio->median, ratio->low, ratio->high) : ",,";
}

}  // namespace

std::string pointsCsv(const std::vector<SceneResult>& scenes) {
  std::string text =
      "scene,row,library,method,setting,value,e_x,e_v,evaluations,jacobians,solves,runs,median_s,least_s,p95_s,low_s,"
      "high_s,failure\n";
  for (const SceneResult& scene : scenes) {
    for (const Curve& curve : scene.curves) {
      for (const CurvePoint& point : curve.points) {
        const Statistics s = statisticsOf(point.seconds);
        const std::string errors =
            point.failed() ? "," : fmt::format("{:.6g},{:.6g}", point.error.position, point.error.velocity);
        text += fmt::format("{},{},{},{},{},{:.6g},{},{},{},{},{},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},{}\n", scene.name,
                            nameOf(curve.row), curve.library, curve.method, curve.takesTolerance ? "tolerance" : "step",
                            point.setting, errors, point.cost.evaluations, point.cost.jacobians, point.cost.solves,
                            s.count, s.median, s.least, s.percentile95, s.low, s.high, csvField(point.cost.failure));
      }
    }
  }
  return text;
}

std::string barsCsv(const std::vector<Bar>& bars) {
  std::string text = "where,promise,measured,verdict\n";
  for (const Bar& bar : bars) {
    text += fmt::format("{},{},{},{}\n", csvField(bar.where), csvField(bar.promise), csvField(bar.measured),
                        nameOf(bar.verdict));
  }
  return text;
}

std::string planeCsv(const std::vector<SceneResult>& scenes) {
  std::string text = "scene,target,entry";
  for (const char* row : {"ours", "A", "B", "A_with_events"}) {
    text += fmt::format(",{0},{0}_s,{0}_low_s,{0}_high_s,{0}_evaluations", row);
  }
  for (const char* row : {"A", "B", "A_with_events"}) {
    text += fmt::format(",{0}_over_ours,{0}_over_ours_low,{0}_over_ours_high", row);
  }
  text += ",fewest_evaluations_ours,fewest_evaluations_A\n";
  for (const SceneResult& scene : scenes) {
    for (const Entry& e : entriesOf(scene)) {
      text += fmt::format("{},{:g},{},{},{},{},{},{},{},{},{:.0f},{:.0f}\n", scene.name, e.target,
                          e.allowed ? "yes" : "no", bestFields(e.ours), bestFields(e.plain), bestFields(e.kernel),
                          bestFields(e.plainWithEvents), ratioFields(e.toPlain), ratioFields(e.toKernel),
                          ratioFields(e.toPlainWithEvents), e.fewestOurs, e.fewestPlain);
    }
  }
  return text;
}

}  // namespace muelle::bench
