#include "lab/rest/rest_scene.h"

#include "lab/run/summary_line.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

namespace muelle::lab {

using namespace engine;

namespace {

constexpr std::size_t shownNodes = 6;

std::string counted(std::size_t count, const std::string& one, const std::string& many) {
  return fmt::format("{} {}", count, count == 1 ? one : many);
}

std::string sizeLine(const Scene& scene, const SceneAtRest& rest) {
  const Model& model = scene.model;
  std::string text =
      counted(model.nodes.size(), "node", "nodes") + ", " + counted(model.springs.size(), "spring", "springs");
  const auto add = [&](std::size_t count, const std::string& one, const std::string& many) {
    if (count > 0) text += ", " + counted(count, one, many);
  };
  engine::forEachElementKind(model, [&]<class List>(const List& elements) {
    const std::string kind = engine::ElementOf<List>::kind;
    add(elements.size(), kind, kind + "s");
  });
  add(model.properties.size(), "property", "properties");
  add(model.obstacles.size(), "obstacle", "obstacles");
  return text + ", " + counted(static_cast<std::size_t>(rest.system->size()), "unknown", "unknowns");
}

/// "nodes 0, 1, 2"; the first few of many.
std::string nodeList(const std::vector<int>& nodes) {
  std::string text = nodes.size() == 1 ? "node " : "nodes ";
  for (std::size_t i = 0; i < std::min(nodes.size(), shownNodes); ++i) {
    text += fmt::format("{}{}", i == 0 ? "" : ", ", nodes[i]);
  }
  if (nodes.size() > shownNodes) text += fmt::format(" and {} more", nodes.size() - shownNodes);
  return text;
}

std::string springName(const Model& model, std::size_t i) {
  return fmt::format("spring {}, between nodes {} and {}", i, model.springs[i].a, model.springs[i].b);
}

std::string cuspLine(const SceneAtRest& rest) {
  const std::vector<SingularPoint>& cusps = rest.result.cusps;
  std::string text = fmt::format("cusp: at {} the energy has no gradient, so no force can be judged; {}",
                                 nodeList(rest.result.nodes), cusps.front().what);
  if (cusps.size() > 1) text += fmt::format(" (and {} more such)", cusps.size() - 1);
  return text;
}

std::string unsupportedLine(const SceneAtRest& rest) {
  const RestResult& result = rest.result;
  if (result.nodes.empty()) {
    return "unsupported: the energy falls without end, for nothing stops what the loads move";
  }
  const bool one = result.nodes.size() == 1;
  return fmt::format("unsupported: {} {} tied to nothing that holds, and {} of {:.4g} N in all", nodeList(result.nodes),
                     one ? "is" : "are", one ? "carries a load" : "carry loads", result.carried.norm());
}

std::string verdictLine(const SceneAtRest& rest) {
  const RestResult& result = rest.result;
  switch (result.verdict) {
    case Verdict::Stable:
      return result.isLowest ? "stable: every small displacement costs energy; no spring pushes, so no shape has less"
                             : "stable: every small displacement costs energy";
    case Verdict::Saddle:
      return "saddle: the forces balance, and the slightest push sends it away";
    case Verdict::Neutral:
      return "neutral: the forces balance, and some displacement costs no energy, to second order and round-off";
    case Verdict::Unsure:
      return "balanced, but whether it is stable cannot be told: the stiffness matrix could not be factorised";
    case Verdict::Cusp:
      return cuspLine(rest);
    case Verdict::Unsupported:
      return unsupportedLine(rest);
    case Verdict::NoneFound:
      break;
  }
  return "none found: the search ended where the forces do not balance";
}

std::string eigenvalueLine(const RestResult& result) {
  std::string text = fmt::format("{:.6g} N/m, the smallest of the stiffness matrix", result.smallestEigenvalue);
  if (result.verdict == Verdict::Neutral) {
    text = fmt::format("{:.1g} N/m, the smallest of the stiffness matrix: 0 within its round-off of {:.1g} N/m",
                       result.smallestEigenvalue, result.eigenvalueRoundOff);
  }
  if (result.negativeEigenvalues > 1) text += fmt::format(", one of {} below 0", result.negativeEigenvalues);
  if (result.softestNode >= 0) text += fmt::format("; it moves node {} most", result.softestNode);
  return text;
}

std::string balanceLine(const RestResult& result) {
  if (result.residual == 0.0) return "the forces sum to 0 at every node";
  std::string text = fmt::format("forces sum to {:.2g} N at most", result.residual);
  if (result.worstNode >= 0) text += fmt::format(", at node {}", result.worstNode);
  if (result.load > 0.0)
    text += fmt::format(": {:.1g} of the load of {:.4g} N", result.residual / result.load, result.load);
  if (result.isFound() && result.residual > 0.0) text += fmt::format("; round-off: {:.1g} N", result.roundOff);
  return text;
}

/// Smallest and largest tension, how many springs pull, push and do nothing.
std::string tensionLines(const Model& model, const RestResult& result) {
  std::size_t least = 0, most = 0;
  std::size_t pulling = 0, pushing = 0;
  bool any = false;
  double largest = 0.0;
  for (const double T : result.tensions) {
    if (std::isfinite(T)) largest = std::max(largest, std::abs(T));
  }
  for (std::size_t i = 0; i < result.tensions.size(); ++i) {
    const double T = result.tensions[i];
    if (!std::isfinite(T)) continue;
    if (!any || T < result.tensions[least]) least = i;
    if (!any || T > result.tensions[most]) most = i;
    any = true;
    if (T > 1e-12 * largest) ++pulling;
    if (T < -1e-12 * largest) ++pushing;
  }
  if (!any) return {};
  const std::size_t idle = result.tensions.size() - pulling - pushing;
  if (pulling + pushing == 0) return summaryLine("tensions", "none: every spring has its rest length");
  std::string text;
  const auto add = [&](std::size_t i) {
    text += summaryLine(text.empty() ? "tensions" : "", fmt::format("{:.6g} N, {}{}", result.tensions[i],
                                                                    result.tensions.size() == 1 ? ""
                                                                    : i == most                 ? "the largest: "
                                                                                                : "the least: ",
                                                                    springName(model, i)));
  };
  add(most);
  if (least != most) add(least);
  if (result.tensions.size() > 1) {
    std::string count = fmt::format("{} pull, {} push", pulling, pushing);
    if (idle > 0) count += fmt::format(", {} do neither", idle);
    text += summaryLine("", count);
  }
  if (result.unknownTensions > 0) {
    text += summaryLine("", fmt::format("{} solved for beside the positions; lengths L0 + T/k met to {:.1g} m",
                                        result.unknownTensions, result.lengthError));
  }
  return text;
}

std::string workLine(const Work& work) {
  const auto number = [](long long count) { return static_cast<std::size_t>(count); };
  return counted(number(work.factorisations), "factorisation", "factorisations") + ", " +
         counted(number(work.solves), "solve", "solves") + ", " +
         counted(number(work.forceEvaluations), "force evaluation", "force evaluations");
}

/// Whether a node is moved, or an obstacle or a force changes with time.
bool changesWithTime(const Model& model) {
  return !model.motions.empty() || std::ranges::any_of(model.obstacles, [](const Obstacle& o) {
    return !o.velocity.isZero(0.0);
  }) || std::ranges::any_of(model.externalForces, [](const ModelExternalForce& f) {
    return !f.times.empty() || f.mayJump || std::ranges::any_of(f.periods, [](double p) { return std::isfinite(p); });
  });
}

std::string notes(const Scene& scene, const SceneAtRest& rest) {
  const RestResult& result = rest.result;
  const Model& model = scene.model;
  std::string text;
  const auto note = [&](const std::string& what) { text += summaryLine("note", what); };
  if (changesWithTime(model)) {
    note(fmt::format("what changes with time is taken as it is at {:.6g} s; --at SECONDS takes another time",
                     rest.options.time));
  }
  if (std::ranges::any_of(model.obstacles, [](const Obstacle& o) { return o.material.mu > 0.0; })) {
    note("friction is left out: where it alone holds a scene, this says neutral or finds nothing");
  }
  if (result.byForceDensity && result.isFound()) {
    note("found from the shape of a net under its loads, as the way from the scene's start was long");
  }
  if (result.saddlesLeft > 0) {
    note(result.saddlesLeft == 1 ? "a saddle was left on the way"
                                 : fmt::format("{} saddles were left on the way", result.saddlesLeft));
  }
  if (result.verdict == Verdict::Saddle && !rest.options.leaveSaddles)
    note("--leave-saddles goes on downhill from here");
  if (result.verdict == Verdict::Cusp) note("move one of the nodes a little, to the side where it should go");
  if (!result.nodes.empty() && result.verdict == Verdict::Unsupported) note("pin a node, or put an obstacle below");
  if (result.verdict == Verdict::NoneFound)
    note("start nearer to a shape at rest, or let the scene come to it: ./muelle run with drag");
  return text;
}

}  // namespace

SceneAtRest restScene(const Scene& scene, const RestOptions& options) {
  if (!(options.time >= 0.0) || !std::isfinite(options.time)) {
    throw std::invalid_argument(fmt::format("--at is {} s; it is a time from 0 on", options.time));
  }
  SceneAtRest rest;
  rest.system = build(scene.model);
  rest.options = options;
  rest.result = engine::rest(*rest.system, options);
  return rest;
}

std::string nameOf(Verdict verdict) {
  switch (verdict) {
    case Verdict::Stable:
      return "stable";
    case Verdict::Saddle:
      return "saddle";
    case Verdict::Neutral:
      return "neutral";
    case Verdict::Unsure:
      return "unsure";
    case Verdict::Cusp:
      return "cusp";
    case Verdict::Unsupported:
      return "unsupported";
    case Verdict::NoneFound:
      break;
  }
  return "none found";
}

std::string summaryOf(const Scene& scene, const SceneAtRest& rest) {
  const RestResult& result = rest.result;
  std::string text = fmt::format("{}: {}\n", scene.name, scene.title);
  text += summaryLine("scene", sizeLine(scene, rest));
  for (const std::string& warning : scene.warnings) text += summaryLine("warning", warning);
  text += summaryLine("verdict", verdictLine(rest));
  const bool hasEigenvalue = result.isFound() && result.verdict != Verdict::Unsure;
  if (hasEigenvalue) text += summaryLine("eigenvalue", eigenvalueLine(result));
  if (result.isFound() || result.verdict == Verdict::NoneFound) {
    text += summaryLine("balance", balanceLine(result));
    text += tensionLines(scene.model, result);
    text += summaryLine("energy", fmt::format("{:.9g} J", result.energy));
    text += summaryLine("moved", fmt::format("{:.4g} m at most from the scene's start", result.furthest));
  }
  if (result.work.factorisations > 0) text += summaryLine("work", workLine(result.work));
  return text + notes(scene, rest);
}

}  // namespace muelle::lab
