#include "engine/kernels/grid_springs.h"

#include "engine/kernels/kernel_table.h"
#include "engine/kernels/loops/spring_force.h"

#include <algorithm>

namespace muelle::engine::kernels {

namespace {

constexpr std::size_t cacheLine = 8;  // doubles
constexpr std::size_t usualBlock = 1024;

std::size_t roundedUp(std::size_t value, std::size_t unit) { return (value + unit - 1) / unit * unit; }

/// The force of one spring between places a and b; D and the form are known by then.
template <int D>
void addLooseSpring(const SpringData& s, const PlanarState& at, const PlanarFinish& finish) {
  const auto a = static_cast<std::size_t>(s.a), b = static_cast<std::size_t>(s.b);
  double d[D], w[D] = {}, F[D];
  const double relative = relativeDampingOf(s, D);
  for (std::size_t c = 0; c < D; ++c) {
    d[c] = at.x[c * at.plane + a] - at.x[c * at.plane + b];
    if (dampingOf(s, D) != Damping::None) w[c] = at.v[c * at.plane + a] - at.v[c * at.plane + b];
  }
  springForce<D, true, (D > 1)>(d, w, {s.k, s.L0, relative, s.dProjected}, F);
  for (std::size_t c = 0; c < D; ++c) {
    double* out = finish.out + c * finish.plane;
    out[a] += finish.inverseMass ? F[c] * finish.inverseMass[a] : F[c];
    out[b] -= finish.inverseMass ? F[c] * finish.inverseMass[b] : F[c];
  }
}

/// Whether no product of the material with what FixedWindow allows leaves the range of a float.
bool isWithinFloats(const GridRun& run) {
  const auto isSmall = [](double value) { return value <= FixedWindow::largest; };
  return std::ranges::all_of(run.k, isSmall) && std::ranges::all_of(run.L0, isSmall) &&
         std::ranges::all_of(run.dRelative, isSmall) && std::ranges::all_of(run.dProjected, isSmall);
}

std::vector<float> rounded(const std::vector<double>& values) { return {values.begin(), values.end()}; }

}  // namespace

std::size_t planeFor(std::size_t nodes) {
  const std::size_t least = roundedUp(nodes, cacheLine);
  constexpr std::size_t page = 512;   // doubles after which the sets of the first cache repeat
  constexpr std::size_t third = 168;  // of it, a multiple of a line
  if (least < page) return least;
  const std::size_t rest = least % page;
  return rest <= third ? least - rest + third : least - rest + page + third;
}

GridSprings::GridSprings(int dimension, std::size_t nodes, std::vector<GridRun> runs, std::vector<SpringData> loose,
                         std::size_t block, Precision precision)
    : dimension_(dimension),
      nodes_(nodes),
      lanes_(roundedUp(nodes, cacheLine)),
      block_(roundedUp(block ? block : usualBlock, cacheLine)),
      precision_(dimension > 1 ? precision : Precision::Double),
      runs_(std::move(runs)),
      loose_(std::move(loose)) {
  gap_.resize(runs_.size());
  if (!std::ranges::all_of(runs_, isWithinFloats)) precision_ = Precision::Double;
  if (precision_ == Precision::Double) return;
  for (const GridRun& run : runs_) {
    single_.push_back({rounded(run.k), rounded(run.L0), rounded(run.dRelative), rounded(run.dProjected)});
  }
}

/// Block by block the springs of each run, by `force(run's number, begin, end, where to)`, then the sums of its nodes,
/// by `pass(sums, begin, end)`.
template <class Real, class RunForce, class Pass>
void GridSprings::sweep(GridBuffers<Real>& buffers, const RunForce& force, const Pass& pass) const {
  buffers.clear();
  std::fill(gap_.begin(), gap_.end(), std::size_t{0});
  for (std::size_t begin = 0; begin < lanes_; begin += block_) {
    const std::size_t end = std::min(begin + block_, lanes_);
    for (std::size_t r = 0; r < runs_.size(); ++r) {
      const GridRun& run = runs_[r];
      const std::size_t from = std::clamp(run.begin, begin, end), to = std::clamp(run.end, from, end);
      if (from < to) force(r, from, to, PlanesOf<Real>{buffers.own(r, begin) + (from - begin), buffers.plane(r)});
      buffers.clearRest(r, begin, from, to, end);
      for (; gap_[r] < run.gaps.size() && run.gaps[gap_[r]] < end; ++gap_[r]) {
        buffers.clearNode(r, begin, run.gaps[gap_[r]]);
      }
      buffers.repeatFirst(r, begin, end);
    }
    pass({runs_.size(), buffers.ownOfAll(begin), buffers.pastOfAll(begin), buffers.planes()}, begin, end);
    buffers.keepPast(begin, end);
  }
}

void GridSprings::evaluate(const PlanarState& at, const PlanarFinish& finish) const {
  const bool isSingle = precision_ == Precision::Single && finish.added != finish.out && evaluateSingle(at, finish);
  if (!isSingle) evaluateDouble(at, finish);
  for (std::size_t c = 0; c < static_cast<std::size_t>(dimension_); ++c) {
    double* plane = finish.out + c * finish.plane;
    std::fill(plane + lanes_, plane + finish.plane, 0.0);
  }
  addLoose(at, finish);
}

void GridSprings::evaluateDouble(const PlanarState& at, const PlanarFinish& finish) const {
  if (!sums_) sums_.emplace(dimension_, lanes_, block_, strides());
  const auto force = [&](std::size_t r, std::size_t from, std::size_t to, const Planes& out) {
    const GridRun& run = runs_[r];
    const RunArrays arrays = {run.stride,           run.begin, run.k.data(), run.L0.data(), run.dRelative.data(),
                              run.dProjected.data()};
    kernels().forceOfRun[dimension_ - 1][static_cast<int>(run.damping)][run.isConstant ? 1 : 0](arrays, at, from, to,
                                                                                                out);
  };
  const auto pass = [&](const NodeSums& sums, std::size_t begin, std::size_t end) {
    kernels().planarPass[dimension_ - 1](sums, finish, begin, end);
  };
  sweep(*sums_, force, pass);
}

/// \return whether it could be done
bool GridSprings::evaluateSingle(const PlanarState& at, const PlanarFinish& finish) const {
  if (!singleSums_) {
    const std::vector<std::size_t> ahead = strides();
    const std::size_t reach = block_ + (ahead.empty() ? 0 : *std::ranges::max_element(ahead));
    singleSums_.emplace(dimension_, lanes_, block_, ahead);
    x_.emplace(dimension_, reach);
    if (runsAreDamped()) v_.emplace(dimension_, reach);
  }
  while (true) {
    sweepSingle(at, finish);
    const auto ofX = x_->verdict(), ofV = v_ ? v_->verdict() : FixedWindow::Verdict::Right;
    if (ofX == FixedWindow::Verdict::OutOfRange || ofV == FixedWindow::Verdict::OutOfRange) return false;
    if (ofX == FixedWindow::Verdict::Right && ofV == FixedWindow::Verdict::Right) return true;
  }
}

void GridSprings::sweepSingle(const PlanarState& at, const PlanarFinish& finish) const {
  x_->begin(at.x, at.plane, nodes_);
  if (v_) v_->begin(at.v, at.plane, nodes_);
  const auto force = [&](std::size_t r, std::size_t from, std::size_t to, const SinglePlanes& out) {
    const GridRun& run = runs_[r];
    const SingleMaterial& m = single_[r];
    const std::size_t first = run.isConstant ? 0 : from - run.begin;
    const auto behind = [first](const std::vector<float>& values) {
      return values.empty() ? nullptr : values.data() + first;
    };
    const SingleRunArrays arrays = {run.stride, behind(m.k), behind(m.L0), behind(m.dRelative), behind(m.dProjected)};
    const std::size_t block = from / block_ * block_;
    const std::int32_t* x = x_->from(block) + (from - block);
    const std::int32_t* v = v_ ? v_->from(block) + (from - block) : x;
    kernels().forceOfRunSingle[dimension_ - 1][static_cast<int>(run.damping)][run.isConstant ? 1 : 0](
        arrays, {x, v, x_->plane(), x_->unit(), v_ ? v_->unit() : 1.0F}, to - from, out);
  };
  const auto pass = [&](const SingleNodeSums& sums, std::size_t begin, std::size_t end) {
    kernels().planarPassSingle[dimension_ - 1](sums, finish, begin, end);
  };
  sweep(*singleSums_, force, pass);
}

bool GridSprings::runsAreDamped() const {
  return std::any_of(runs_.begin(), runs_.end(), [](const GridRun& run) { return run.damping != Damping::None; });
}

std::vector<std::size_t> GridSprings::strides() const {
  std::vector<std::size_t> strides;
  for (const GridRun& run : runs_) strides.push_back(run.stride);
  return strides;
}

void GridSprings::addLoose(const PlanarState& at, const PlanarFinish& finish) const {
  for (const SpringData& s : loose_) {
    if (dimension_ == 1) addLooseSpring<1>(s, at, finish);
    if (dimension_ == 2) addLooseSpring<2>(s, at, finish);
    if (dimension_ == 3) addLooseSpring<3>(s, at, finish);
  }
}

std::size_t GridSprings::springs() const {
  std::size_t count = loose_.size();
  for (const GridRun& run : runs_) count += run.springs();
  return count;
}

bool GridSprings::usesVelocity() const {
  const auto isDamped = [this](const SpringData& s) { return dampingOf(s, dimension_) != Damping::None; };
  return runsAreDamped() || std::any_of(loose_.begin(), loose_.end(), isDamped);
}

}  // namespace muelle::engine::kernels
