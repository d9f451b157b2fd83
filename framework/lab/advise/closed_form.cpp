#include "lab/advise/closed_form.h"

#include "base/text/count.h"
#include "engine/analysis/linearised_system.h"
#include "engine/scene/joined_sets.h"
#include "engine/solve/dense.h"
#include "lab/advise/method_search.h"
#include "lab/run/energy_balance.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>

namespace muelle::lab {

using namespace engine;

namespace {

constexpr int mostUnknowns = 300;  // of a dense eigenproblem that takes a blink

/// Position and velocity of q'' = f - s q after t, from 0 with velocity v.
std::pair<double, double> modeAt(double s, double f, double v, double t) {
  const double w = std::sqrt(std::abs(s));
  if (w * t < 1e-6) return {v * t + 0.5 * f * t * t, v + f * t};
  if (s > 0.0) {
    return {v * std::sin(w * t) / w + f * (1.0 - std::cos(w * t)) / s, v * std::cos(w * t) + f * std::sin(w * t) / w};
  }
  return {v * std::sinh(w * t) / w + f * (std::cosh(w * t) - 1.0) / -s,
          v * std::cosh(w * t) + f * std::sinh(w * t) / w};
}

/// The motion about the start by its modes.
class LinearModes {
 public:
  explicit LinearModes(const ModelSystem& system)
      : system_(system), start_(system.initialState()), linearised_(system, start_) {
    const int n = linearised_.size();
    MatX K(n, n);
    std::vector<double> unit(static_cast<std::size_t>(n), 0.0), image(unit);
    root_.resize(n);
    for (int i = 0; i < n; ++i) root_[i] = std::sqrt(linearised_.system().mass()[static_cast<std::size_t>(i)]);
    for (int i = 0; i < n; ++i) {
      unit[static_cast<std::size_t>(i)] = 1.0;
      linearised_.stiffness(unit, image);
      unit[static_cast<std::size_t>(i)] = 0.0;
      for (int j = 0; j < n; ++j) K(j, i) = image[static_cast<std::size_t>(j)] / (root_[i] * root_[j]);
    }
    modes_ = symmetricEigenpairs(K);
    const State compact = linearised_.system().compact(start_);
    std::vector<double> force(compact.x.size());
    linearised_.system().force(0.0, compact.x, compact.v, compact.z, force);
    const Eigen::Map<const VecX> F(force.data(), n), v(compact.v.data(), n);
    force_ = modes_.vectors.transpose() * F.cwiseQuotient(root_);
    velocity_ = modes_.vectors.transpose() * v.cwiseProduct(root_);
  }

  PathRows rows(const std::vector<double>& times) const {
    PathRows rows;
    State compact = linearised_.system().compact(start_);
    const std::vector<double> begin = compact.x;
    for (const double t : times) {
      VecX q(root_.size()), dq(root_.size());
      for (Eigen::Index i = 0; i < root_.size(); ++i) {
        std::tie(q[i], dq[i]) = modeAt(modes_.values[i], force_[i], velocity_[i], t);
      }
      const VecX y = (modes_.vectors * q).cwiseQuotient(root_), dy = (modes_.vectors * dq).cwiseQuotient(root_);
      for (std::size_t i = 0; i < begin.size(); ++i) {
        compact.x[i] = begin[i] + y[static_cast<Eigen::Index>(i)];
        compact.v[i] = dy[static_cast<Eigen::Index>(i)];
      }
      State whole = start_;
      whole.t = compact.t = t;
      linearised_.system().expand(compact, whole);
      rows.add(system_, whole);
    }
    return rows;
  }

 private:
  const ModelSystem& system_;
  State start_;
  LinearisedSystem linearised_;
  VecX root_;  ///< of the masses
  SymmetricEigenpairs modes_;
  VecX force_, velocity_;  ///< of each mode at the start
};

bool hasElements(const Model& model) {
  return !model.springs.empty() || elementCount(model) > 0 || !model.properties.empty();
}

ClosedForm judged(std::string name, double error, double tolerance, const char* words) {
  ClosedForm form{std::move(name), error, error <= tolerance, ""};
  form.why = form.holds ? fmt::format("{}: no step is needed", words) : fmt::format("it is off by {:.2g}", error);
  return form;
}

ClosedForm linearModes(const Pilots& whole, const ReferenceMotion& reference, double tolerance) {
  const PathRows rows = LinearModes(whole.system()).rows(reference.run.rows.t);
  const double found = reference.errorOf(whole, rows);
  const double error =
      std::isfinite(found) ? statedError(found, reference.doubt) : std::numeric_limits<double>::infinity();
  return judged("linear modes", error, tolerance, "each mode about the start for itself");
}

ClosedForm freeFlight(const Pilots& whole, const ReferenceMotion& reference, double tolerance) {
  PathRows rows;
  const ModelSystem& system = whole.system();
  const State start = system.initialState();
  std::vector<double> a(start.x.size());
  system.acceleration(0.0, start.x, start.v, start.z, a);
  for (const double t : reference.run.rows.t) {
    State state = start;
    state.t = t;
    for (std::size_t i = 0; i < a.size(); ++i) {
      state.x[i] += start.v[i] * t + 0.5 * a[i] * t * t;
      state.v[i] += a[i] * t;
    }
    system.place(t, state.z, state.x, state.v);
    rows.add(system, state);
  }
  return judged("free flight", statedError(reference.errorOf(whole, rows), reference.doubt), tolerance,
                "x0 + v0 t + g t²/2");
}

}  // namespace

std::vector<std::vector<int>> islandsOf(const Model& model) {
  JoinedSets groups(static_cast<int>(model.nodes.size()));
  const auto isMoving = [&](int node) { return isFree(model.nodes[static_cast<std::size_t>(node)]); };
  // What is held passes nothing on.
  const auto join = [&](const auto& nodes) {
    int first = -1;
    for (const int node : nodes) {
      if (!isMoving(node)) continue;
      if (first >= 0) groups.join(first, node);
      first = node;
    }
  };
  for (const ModelSpring& s : model.springs) join(std::array{s.a, s.b});
  forEachElementKind(model, [&](const auto& elements) {
    for (const auto& element : elements) join(element.nodes);
  });
  for (const ModelProperty& property : model.properties) join(property.nodes);
  std::vector<std::vector<int>> islands;
  std::vector<int> islandOf(model.nodes.size(), -1);
  for (int node = 0; node < static_cast<int>(model.nodes.size()); ++node) {
    if (!isMoving(node)) continue;
    int& island = islandOf[static_cast<std::size_t>(groups.of(node))];
    if (island < 0) {
      island = static_cast<int>(islands.size());
      islands.emplace_back();
    }
    islands[static_cast<std::size_t>(island)].push_back(node);
  }
  return islands;
}

std::vector<ClosedForm> closedForms(const Pilots& whole, const ReferenceMotion& reference, double tolerance) {
  const ModelSystem& system = whole.system();
  const Model& model = system.model();
  std::vector<ClosedForm> forms;
  const bool isKept = energyFate(system) == EnergyFate::Kept && system.rods().empty();
  if (!isKept) return forms;
  if (!hasElements(model)) {
    forms.push_back(freeFlight(whole, reference, tolerance));
  } else if (!reference.run.touches() && system.size() <= mostUnknowns) {
    forms.push_back(linearModes(whole, reference, tolerance));
  }
  return forms;
}

}  // namespace muelle::lab
