#include "peers.h"

#include "gsl.h"
#include "naive.h"
#include "odeint.h"
#include "problem.h"
#include "sundials.h"

#include <fmt/format.h>
#include <boost/version.hpp>
#include <optional>

namespace muelle::bench {

struct Peers::Problems {
  std::optional<PlainProblem<1>> line;
  std::optional<PlainProblem<2>> plane;
  std::optional<PlainProblem<3>> space;
  KernelProblem kernel;

  Problems(const BenchScene& scene, const engine::ModelSystem& system) : kernel(scene, system) {
    if (scene.model.dimension == 1) line.emplace(scene);
    if (scene.model.dimension == 2) plane.emplace(scene);
    if (scene.model.dimension == 3) space.emplace(scene);
  }
};

namespace {

template <class Problem>
void addAll(const Problem& problem, Contestants& all) {
  addNaive(problem, all);
  addOdeint(problem, all);
  addGsl(problem, all);
  addSundials(problem, all);
}

}  // namespace

Peers::Peers(const BenchScene& scene, const engine::ModelSystem& system)
    : scene_(scene), problems_(std::make_unique<Problems>(scene, system)) {}

Peers::~Peers() = default;

std::vector<std::string> Peers::versions() {
  return {fmt::format("Boost {}.{}", BOOST_VERSION / 100'000, BOOST_VERSION / 100 % 1000), gslVersion(),
          sundialsVersion()};
}

void Peers::addTo(Contestants& all) const {
  if (problems_->line) addAll(*problems_->line, all);
  if (problems_->plane) addAll(*problems_->plane, all);
  if (problems_->space) addAll(*problems_->space, all);
  addAll(problems_->kernel, all);
  if (scene_.kind != SceneKind::Bounce) return;
  addOdeintBall(scene_, all);
  addCvodeBall(scene_, all);
}

}  // namespace muelle::bench
