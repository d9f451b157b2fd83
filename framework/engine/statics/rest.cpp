#include "engine/statics/rest.h"

#include "engine/compact_system.h"
#include "engine/model/axes.h"
#include "engine/statics/at_rest.h"
#include "engine/statics/equilibrium.h"
#include "engine/statics/softer_springs.h"
#include "engine/statics/support.h"
#include "engine/statics/tension_form.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <stdexcept>

namespace muelle::engine {

namespace {

constexpr long long firstTry = 40;    // factorisations from the scene's start, before force densities have a go
constexpr int glancing = 12;          // Newton's method from the scene's start
constexpr int polishing = 20;         // and at the end, on tensions
constexpr int fromForceDensity = 25;  // from the shape of a net under its loads

/// Whether springs, gravity and forces are all there is: then a shape in which all springs pull is the lowest.
bool isNet(const Model& model) {
  const bool pushOnly = std::ranges::any_of(model.springs, [](const ModelSpring& s) { return s.unilateral; });
  return !pushOnly && elementCount(model) == 0 && model.properties.empty() && model.obstacles.empty();
}

/// Tensions here are those of lengths, which a signed spring and a rod have not.
void checkSprings(const Model& model) {
  for (std::size_t i = 0; i < model.springs.size(); ++i) {
    const ModelSpring& s = model.springs[i];
    if (s.rod) throw std::invalid_argument(fmt::format("spring {} is a rod: rest needs a stiffness k in its place", i));
    if (s.isSigned) throw std::invalid_argument(fmt::format("spring {} is signed: rest knows springs by distance", i));
  }
}

class RestSearch {
 public:
  RestSearch(const ModelSystem& system, const RestOptions& options)
      : system_(system), options_(options), still_(system, options.time) {}
  RestResult run();

 private:
  void placeAtTime();
  void search();
  bool standsAlready();
  bool isUphill(const std::vector<double>& x, double rounding) const;
  bool fromStart(long long mostFactorisations);
  bool fromForceDensities();
  bool fromSofter();
  bool keep(std::unique_ptr<TensionForm> form);
  StaticOptions searchOptions(long long mostFactorisations) const;
  bool polish();
  bool startIsNoShape() const;
  void descend();
  const Curvature& shapeCurvature();
  void judge();
  bool onCusp();
  void take(const TensionForm& form, const Imbalance& imbalance);
  double elementSize() const;
  int nodeOf(int unknown) const;

  const ModelSystem& system_;
  const RestOptions& options_;
  AtRest still_;
  RestResult result_;
  State start_;
  std::unique_ptr<TensionForm> form_;  // of the shape in result_, once it is found
  std::optional<Curvature> curvature_;
  bool found_ = false;
  bool ranAway_ = false;
};

/// The node of the model that an unknown belongs to.
int RestSearch::nodeOf(int unknown) const {
  const int axis = axesOf(system_.model()).front();
  for (int node = 0; node < system_.nodeCount(); ++node) {
    const int first = system_.unknown(node, axis);
    if (first >= 0 && unknown >= first && unknown < first + system_.dimension()) return node;
  }
  return -1;
}

/// The length of a typical element [m]: the median spring's, else the size of the scene.
double RestSearch::elementSize() const {
  std::vector<double> lengths;
  for (const ModelSpring& s : system_.model().springs) {
    const double L = (system_.position(start_, s.a) - system_.position(start_, s.b)).norm();
    lengths.push_back(std::max(L, s.L0));
  }
  if (lengths.empty()) return 1.0;
  const auto middle = lengths.begin() + std::ssize(lengths) / 2;
  std::nth_element(lengths.begin(), middle, lengths.end());
  return *middle > 0.0 ? *middle : 1.0;
}

void RestSearch::placeAtTime() {
  start_ = system_.initialState();
  start_.t = options_.time;
  std::ranges::fill(start_.v, 0.0);
  start_.z.assign(static_cast<std::size_t>(system_.internalSize()), 0.0);
  if (system_.switching() != nullptr) system_.switching()->commit(start_, false);
  result_.state = start_;
}

bool RestSearch::onCusp() {
  result_.cusps = singularPoints(system_, result_.state);
  result_.nodes.clear();
  for (const SingularPoint& cusp : result_.cusps) {
    result_.nodes.insert(result_.nodes.end(), cusp.nodes.begin(), cusp.nodes.end());
  }
  std::ranges::sort(result_.nodes);
  result_.nodes.erase(std::unique(result_.nodes.begin(), result_.nodes.end()), result_.nodes.end());
  return !result_.cusps.empty();
}

void RestSearch::take(const TensionForm& form, const Imbalance& imbalance) {
  result_.state = start_;
  result_.state.x = form.positions();
  result_.tensions = form.tensions();
  result_.residual = imbalance.force;
  result_.worstNode = nodeOf(imbalance.worstUnknown);
  result_.roundOff = imbalance.forceFloor;
  result_.unknownTensions = form.unknownTensions();
  result_.lengthError = std::max(0.0, imbalance.length);
  result_.load = form.load();
  curvature_.reset();
}

/// Newton's method on tensions from the state in the result; whether it ends in balance. Its shape is taken if so.
bool RestSearch::polish() {
  auto form = std::make_unique<TensionForm>(system_, start_);
  form->place(result_.state.x);
  const Imbalance imbalance = form->solve(polishing, false);
  result_.work += form->work();
  if (!imbalance.atRoundOff && !result_.tensions.empty()) return false;
  take(*form, imbalance);
  form_ = std::move(form);
  return imbalance.atRoundOff;
}

/// Whether the change of shape from the start to these positions [m], unless it is rounding, goes against the forces at
/// the start: uphill, where nothing goes that is let go.
bool RestSearch::isUphill(const std::vector<double>& x, double rounding) const {
  std::vector<double> forces(x.size());
  still_.potential()->conservativeForce(start_.t, start_.x, start_.z, forces);
  double work = 0.0, moved = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    work += forces[i] * (x[i] - start_.x[i]);
    moved = std::max(moved, std::abs(x[i] - start_.x[i]));
  }
  return work < 0.0 && moved > rounding;
}

/// Whether the scene's start is an equilibrium but for a small change of shape: Newton's method ends near it. Of a
/// saddle that change has to lie across the ways down, of which there may be many, or the scene stands beside it and
/// falls: a wire drawn a little too short is pressed straight, and its weight bends it.
bool RestSearch::standsAlready() {
  auto form = std::make_unique<TensionForm>(system_, start_);
  const Imbalance imbalance = form->solve(glancing, false);
  result_.work += form->work();
  if (!imbalance.atRoundOff) return false;
  const std::vector<double> x = form->positions();
  const double size = elementSize();
  double moved = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) moved = std::max(moved, std::abs(x[i] - start_.x[i]));
  if (!(moved <= 0.25 * size)) return false;
  take(*form, imbalance);
  form_ = std::move(form);
  const Curvature& curvature = shapeCurvature();
  double down = 0.0;
  const CompactSystem compact(still_);
  std::vector<double> end(static_cast<std::size_t>(system_.size())), begin(end.size());
  compact.gather(x, end);
  compact.gather(start_.x, begin);
  for (std::size_t i = 0; i < curvature.along.size(); ++i) down += curvature.along[i] * (end[i] - begin[i]);
  if (curvature.smallest >= -curvature.roundOff) return true;
  if (std::abs(down) <= 0.01 * size && !isUphill(x, 1e-9 * size)) return true;
  form_.reset();
  result_.state = start_;
  result_.tensions.clear();
  return false;
}

/// Downhill by positions, from where the result stands.
bool RestSearch::fromStart(long long mostFactorisations) {
  const StaticOptions options = searchOptions(mostFactorisations);
  const StaticResult down = equilibrium(still_, result_.state, options);
  result_.work += down.work;
  result_.state = down.state;
  ranAway_ = down.ranAway;
  if (ranAway_) return false;
  // Newton's method may still find its way; but not before force densities have had a go.
  const bool givesWay = mostFactorisations < options_.mostFactorisations && !down.balanced &&
                        down.work.factorisations >= mostFactorisations;
  return !givesWay && polish();
}

bool RestSearch::fromForceDensities() {
  if (!isNet(system_.model())) return false;
  auto form = std::make_unique<TensionForm>(system_, start_);
  const bool placed = form->placeByForceDensity();
  const Imbalance imbalance = placed ? form->solve(fromForceDensity, true) : Imbalance{};
  result_.work += form->work();
  if (!placed || !imbalance.atRoundOff) return false;
  take(*form, imbalance);
  form_ = std::move(form);
  result_.byForceDensity = true;
  return true;
}

bool RestSearch::fromSofter() {
  SofterSearch softer = balanceBySofterSprings(system_, start_, searchOptions(options_.mostFactorisations / 2));
  result_.work += softer.work;
  ranAway_ = softer.ranAway;
  if (ranAway_) result_.state = softer.furthest;
  return softer.form && keep(std::move(softer.form));
}

/// Takes a balanced shape as the one that was found.
bool RestSearch::keep(std::unique_ptr<TensionForm> form) {
  take(*form, form->imbalance());
  form_ = std::move(form);
  return true;
}

/// A search that ends where no node that is held can be, ten times over: the size of the scene, all springs in a row,
/// and what the loads make of the softest.
StaticOptions RestSearch::searchOptions(long long mostFactorisations) const {
  StaticOptions options;
  options.judge = false;
  options.leaveSaddles = false;
  options.mostFactorisations = mostFactorisations;
  options.mostIterations = 5000;
  const Model& model = system_.model();
  double reach = 1.0, softest = 0.0;
  for (const ModelNode& node : model.nodes) reach = std::max(reach, 2.0 * (node.x - model.nodes[0].x).norm());
  for (const Obstacle& obstacle : model.obstacles) reach += (obstacle.centre - model.nodes[0].x).norm();
  for (const ModelSpring& spring : model.springs) {
    reach += spring.L0;
    if (spring.k > 0.0) softest = softest > 0.0 ? std::min(softest, spring.k) : spring.k;
  }
  if (softest > 0.0) reach += static_cast<double>(model.springs.size()) * TensionForm(system_, start_).load() / softest;
  options.furthest = 10.0 * reach;
  return options;
}

/// Whether the springs hold more energy at the start than the loads could have put there.
bool RestSearch::startIsNoShape() const {
  const TensionForm form(system_, start_);
  const std::vector<double> tensions = form.tensions();
  double elastic = 0.0, length = 0.0;
  for (std::size_t i = 0; i < tensions.size(); ++i) {
    const ModelSpring& s = system_.model().springs[i];
    length = std::max(length, s.L0);
    if (s.k > 0.0 && tensions[i] < 0.0) elastic += 0.5 * tensions[i] * tensions[i] / s.k;
  }
  Vec3 low = Vec3::Constant(INFINITY), high = Vec3::Constant(-INFINITY);
  for (int node = 0; node < system_.nodeCount(); ++node) {
    const Vec3 x = system_.position(start_, node);
    low = low.cwiseMin(x);
    high = high.cwiseMax(x);
  }
  return form.load() > 0.0 && elastic > form.load() * std::max((high - low).norm(), length);
}

void RestSearch::search() {
  const bool densitiesFirst = isNet(system_.model()) && startIsNoShape();
  found_ = densitiesFirst ? fromForceDensities() : standsAlready();
  if (!found_ && isNet(system_.model())) {
    found_ = fromStart(firstTry);
    if (found_ || ranAway_) return;
    if (!densitiesFirst) found_ = fromForceDensities();
  }
  if (!found_) found_ = fromSofter();
  if (!found_ && !ranAway_) found_ = fromStart(options_.mostFactorisations);
}

/// From saddle to saddle down to something that is none. Stays on the last one from which no way down is found.
void RestSearch::descend() {
  StaticOptions options = searchOptions(options_.mostFactorisations);
  options.judge = true;
  options.leaveSaddles = true;
  for (int i = 0; i < 20 && result_.verdict == Verdict::Saddle; ++i) {
    const RestResult saddle = result_;
    const StaticResult down = equilibrium(still_, result_.state, options);
    result_.work += down.work;
    result_.state = down.state;
    result_.tensions.clear();
    result_.byForceDensity = false;
    found_ = down.saddlesLeft > 0 && !down.ranAway && polish();
    result_.saddlesLeft += std::max(1, down.saddlesLeft);
    // Stiff springs make the way down too long for a search by positions.
    if (!found_) found_ = fromForceDensities();
    if (!found_) {
      const Work work = result_.work;
      result_ = saddle;
      result_.work = work;
      return;
    }
    judge();
  }
}

/// The curvature at the shape that was found, worked out once.
const Curvature& RestSearch::shapeCurvature() {
  if (curvature_) return *curvature_;
  const Work before = form_->work();
  curvature_ = form_->curvature();
  Work spent = form_->work();
  spent.factorisations -= before.factorisations;
  spent.forceEvaluations -= before.forceEvaluations;
  spent.jacobians -= before.jacobians;
  spent.solves -= before.solves;
  spent.newtonIterations -= before.newtonIterations;
  result_.work += spent;
  return *curvature_;
}

void RestSearch::judge() {
  if (!found_) {
    result_.verdict = ranAway_ ? Verdict::Unsupported : onCusp() ? Verdict::Cusp : Verdict::NoneFound;
    return;
  }
  if (onCusp()) {
    result_.verdict = Verdict::Cusp;
    return;
  }
  const Curvature& curvature = shapeCurvature();
  result_.smallestEigenvalue = curvature.smallest;
  result_.eigenvalueRoundOff = curvature.roundOff;
  result_.negativeEigenvalues = curvature.negative;
  if (!curvature.known) {
    result_.verdict = Verdict::Unsure;
    return;
  }
  if (!curvature.along.empty()) {
    const auto largest = std::ranges::max_element(curvature.along, {}, [](double y) { return std::abs(y); });
    result_.softestNode = nodeOf(static_cast<int>(largest - curvature.along.begin()));
  }
  const bool flat = std::abs(curvature.smallest) <= curvature.roundOff;
  result_.verdict = flat ? Verdict::Neutral : curvature.smallest > 0.0 ? Verdict::Stable : Verdict::Saddle;
  const bool pulls = std::ranges::all_of(result_.tensions, [](double T) { return T >= 0.0; });
  result_.isLowest = pulls && isNet(system_.model()) && !result_.tensions.empty();
}

RestResult RestSearch::run() {
  placeAtTime();
  if (const std::optional<Unsupported> loose = findUnsupported(system_, start_.t)) {
    result_.verdict = Verdict::Unsupported;
    result_.nodes = loose->nodes;
    result_.carried = loose->load;
  } else if (onCusp()) {
    result_.verdict = Verdict::Cusp;
  } else {
    search();
    judge();
    if (options_.leaveSaddles) descend();
  }
  if (result_.tensions.empty()) {
    TensionForm form(system_, start_);
    form.place(result_.state.x);
    take(form, form.imbalance());
  }
  result_.energy = still_.potential()->energy(result_.state.t, result_.state.x, result_.state.z);
  for (int node = 0; node < system_.nodeCount(); ++node) {
    const double way = (system_.position(result_.state, node) - system_.position(start_, node)).norm();
    result_.furthest = std::max(result_.furthest, way);
  }
  return result_;
}

}  // namespace

RestResult rest(const ModelSystem& system, const RestOptions& options) {
  checkSprings(system.model());
  const auto rubs = [](const Obstacle& obstacle) { return obstacle.material.mu > 0.0; };
  if (std::ranges::none_of(system.model().obstacles, rubs)) return RestSearch(system, options).run();
  Model smooth = system.model();
  for (Obstacle& obstacle : smooth.obstacles) obstacle.material.mu = 0.0;
  const auto without = build(smooth);
  RestResult result = RestSearch(*without, options).run();
  // The internal variables are those of the system that was asked for.
  result.state.z.assign(static_cast<std::size_t>(system.internalSize()), 0.0);
  if (system.switching() != nullptr) system.switching()->commit(result.state, false);
  return result;
}

}  // namespace muelle::engine
