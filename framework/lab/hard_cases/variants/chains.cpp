#include "engine/compact_system.h"
#include "engine/solve/dense.h"
#include "lab/hard_cases/variants/families.h"
#include "lab/hard_cases/variants/parts.h"

#include <algorithm>

namespace muelle::hard_cases {

namespace {

/// The modes of a linear scene on a line, started at rest, as they show at one node: amplitudes from the eigenvectors
/// of M^-1 K, in the order of their frequencies.
std::vector<Mode> modesAt(const Model& model, int node) {
  const auto system = engine::build(model);
  const State start = system->initialState();
  engine::SystemMatrix K;
  system->linearisation()->assemble(0, 0, 1, start.t, start.x, start.v, start.z, engine::Form::Exact, K);
  engine::CompactSystem compact(*system);
  compact.follow(start);
  const State unknowns = compact.compact(start);
  const Eigen::Map<const Eigen::VectorXd> mass(compact.mass().data(), system->size());
  const Eigen::VectorXd root = mass.cwiseSqrt();
  Eigen::VectorXd force(system->size());
  compact.force(start.t, unknowns.x, unknowns.v, start.z, {force.data(), unknowns.x.size()});
  const Eigen::MatrixXd stiffness(K.sparse);
  const Eigen::VectorXd fromRest = -engine::solveFullPivoting(stiffness, force);
  const engine::SymmetricEigenpairs pairs =
      engine::symmetricEigenpairs(root.cwiseInverse().asDiagonal() * stiffness * root.cwiseInverse().asDiagonal());
  const Eigen::VectorXd parts = pairs.vectors.transpose() * (root.asDiagonal() * fromRest);
  const auto i = static_cast<Eigen::Index>(system->unknown(node, 0));
  std::vector<Mode> modes;
  for (Eigen::Index j = 0; j < parts.size(); ++j) {
    const Eigen::VectorXd shape = pairs.vectors.col(j).cwiseQuotient(root);
    const double largest = shape.cwiseAbs().maxCoeff();
    modes.push_back({.stiffness = pairs.values[j],
                     .amplitude = std::abs(parts[j]) * largest,
                     .sensitivity = std::copysign(shape[i] / largest, shape[i] * parts[j])});
  }
  return modes;
}

Variant h09() {
  Variant v{.id = "H09", .name = "vertical", .measured = "distance of the lowest node from its equilibrium [m]"};
  v.model = hangingChain(10.0);
  v.duration = 6.0;
  v.bar = 1e-8;
  v.steps = {2e-3, 2e-3, 2e-3, 1.0 / 60, 1e-9};
  v.error = coordinate(99, reference("H09", "vertical.z100"));
  const double top = 2.0 * std::sqrt(1e5);
  v.modes = {{.stiffness = 4.97 * 4.97, .amplitude = 0.5, .drag = 10.0},
             {.stiffness = top * top, .amplitude = 1e-6, .drag = 10.0}};
  v.coupled = 100;
  return v;
}

Variant h10() {
  Variant v{.id = "H10", .name = "longitudinal", .measured = "largest error of four nodes at t = 10 s [m]"};
  v.model = longitudinalChain();
  v.duration = 10.0;
  v.bar = 1e-8;
  v.steps = {1e-3, 2e-3, 0.0125, 1e-3, 1e-11};
  v.error = [](const Finished& end) {
    double largest = 0.0;
    for (const int i : {1, 13, 25, 50}) {
      largest = std::max(
          largest, std::abs(end.x(i - 1)[0] - i - reference("H10", "longitudinal.u" + std::to_string(i) + "(10)")));
    }
    return largest;
  };
  v.modes = {mode(reference("H10", "longitudinal.omega1"), 0.01), mode(reference("H10", "longitudinal.omega50"), 0.01)};
  v.coupled = 51;
  v.linear = true;
  return v;
}

Variant h11() {
  Variant v{.id = "H11", .name = "", .measured = "error of the slow node at t = 10 s [m]", .model = stiffnessRatio()};
  v.duration = 10.0;
  v.bar = 5e-5;  // BDF2 at 1/60 s has 0.1 * 10 h^2/3 sin(10) = 4.9e-5
  v.steps = {1.0 / 600, 1.0 / 600, 1.0 / 600, 1.0 / 60, 1e-7};
  v.error = coordinate(1, 2.0 + reference("H11", "u2(10)"));
  v.modes = modesAt(v.model, 1);
  v.coupled = 2;
  v.linear = true;
  return v;
}

Variant h12() {
  Variant v{.id = "H12", .name = "one_d", .measured = "error of the heavy node at t = 1 s [m]"};
  v.model = heavyBelowLight();
  v.bar = 2e-3;
  v.steps = {1.0 / 8000, 1.0 / 8000, 1.0 / 8000, 1.0 / 60, 1e-6};
  v.error = coordinate(1, reference("H12", "one_d.z2(1)"));
  v.modes = modesAt(v.model, 1);
  v.coupled = 2;
  v.linear = true;
  return v;
}

}  // namespace

std::vector<Variant> chainVariants() { return {h09(), h10(), h11(), h12()}; }

}  // namespace muelle::hard_cases
