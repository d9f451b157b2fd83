#include "engine/kernels/grid_springs.h"

#include "engine/kernels/kernel_table.h"
#include "engine/kernels/loops/spring_force.h"

#include <algorithm>
#include <cstdint>

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
                         std::size_t block)
    : dimension_(dimension),
      lanes_(roundedUp(nodes, cacheLine)),
      block_(roundedUp(block ? block : usualBlock, cacheLine)),
      runs_(std::move(runs)),
      loose_(std::move(loose)) {
  std::size_t size = 0;
  for (const GridRun& run : runs_) {
    buffers_.push_back(bufferFor(run.stride, size));
    planes_.push_back(buffers_.back().plane);
    size += static_cast<std::size_t>(dimension_) * buffers_.back().plane;
  }
  scratch_.resize(size + cacheLine);
  gap_.resize(runs_.size());
  own_.resize(runs_.size());
  past_.resize(runs_.size());
}

GridSprings::Buffer GridSprings::bufferFor(std::size_t stride, std::size_t offset) const {
  Buffer buffer = {stride, 0, 0, 0, offset};
  // A copy of what the next block needs, as long as that is little; or there is no next block.
  if (stride <= 2 * block_ || lanes_ <= block_) {
    buffer.lead = roundedUp(stride, cacheLine);
    buffer.plane = buffer.lead + block_;
  } else {
    buffer.ring = roundedUp(stride, block_) + 2 * block_;
    buffer.plane = buffer.ring + block_;
  }
  buffer.plane += 9 * cacheLine;  // the components apart in the sets of the first cache
  return buffer;
}

double* GridSprings::scratch() const {
  const auto address = reinterpret_cast<std::uintptr_t>(scratch_.data());
  return scratch_.data() + (cacheLine - address / sizeof(double) % cacheLine) % cacheLine;
}

void GridSprings::evaluate(const PlanarState& at, const PlanarFinish& finish) const {
  clearPast();
  std::fill(gap_.begin(), gap_.end(), std::size_t{0});
  const auto pass = kernels().planarPass[dimension_ - 1];
  for (std::size_t begin = 0; begin < lanes_; begin += block_) {
    const std::size_t end = std::min(begin + block_, lanes_);
    for (std::size_t r = 0; r < runs_.size(); ++r) {
      runBlock(r, at, begin, end);
      own_[r] = scratch() + buffers_[r].own(begin);
      past_[r] = scratch() + buffers_[r].past(begin);
    }
    pass({runs_.size(), own_.data(), past_.data(), planes_.data()}, finish, begin, end);
    for (std::size_t r = 0; r < runs_.size(); ++r) keepPast(r, begin, end);
  }
  for (std::size_t c = 0; c < static_cast<std::size_t>(dimension_); ++c) {
    double* plane = finish.out + c * finish.plane;
    std::fill(plane + lanes_, plane + finish.plane, 0.0);
  }
  addLoose(at, finish);
}

void GridSprings::clearPast() const {
  for (const Buffer& buffer : buffers_) {
    for (std::size_t c = 0; c < static_cast<std::size_t>(dimension_); ++c) {
      double* plane = scratch() + buffer.offset + c * buffer.plane;
      double* zero = plane + (buffer.ring ? buffer.ring : buffer.lead);
      std::fill(zero - buffer.stride, zero, 0.0);
    }
  }
}

void GridSprings::runBlock(std::size_t r, const PlanarState& at, std::size_t begin, std::size_t end) const {
  const GridRun& run = runs_[r];
  const Buffer& buffer = buffers_[r];
  double* own = scratch() + buffer.own(begin);
  const std::size_t from = std::clamp(run.begin, begin, end), to = std::clamp(run.end, from, end);
  if (from < to) {
    const RunArrays arrays = {run.stride,           run.begin, run.k.data(), run.L0.data(), run.dRelative.data(),
                              run.dProjected.data()};
    const auto force = kernels().forceOfRun[dimension_ - 1][static_cast<int>(run.damping)][run.isConstant ? 1 : 0];
    force(arrays, at, from, to, {own + (from - begin), buffer.plane});
  }
  for (std::size_t c = 0; c < static_cast<std::size_t>(dimension_); ++c) {
    double* plane = own + c * buffer.plane;
    std::fill(plane, plane + (from - begin), 0.0);
    std::fill(plane + (to - begin), plane + (end - begin), 0.0);
  }
  for (; gap_[r] < run.gaps.size() && run.gaps[gap_[r]] < end; ++gap_[r]) {
    for (std::size_t c = 0; c < static_cast<std::size_t>(dimension_); ++c) {
      own[c * buffer.plane + (run.gaps[gap_[r]] - begin)] = 0.0;
    }
  }
  if (buffer.ring && begin % buffer.ring == 0) {
    for (std::size_t c = 0; c < static_cast<std::size_t>(dimension_); ++c) {
      double* plane = own + c * buffer.plane;
      std::copy(plane, plane + (end - begin), plane + buffer.ring);
    }
  }
}

void GridSprings::keepPast(std::size_t r, std::size_t begin, std::size_t end) const {
  const Buffer& buffer = buffers_[r];
  if (buffer.ring || end == lanes_) return;
  for (std::size_t c = 0; c < static_cast<std::size_t>(dimension_); ++c) {
    double* own = scratch() + buffer.own(begin) + c * buffer.plane;
    std::copy(own + (end - begin) - buffer.stride, own + (end - begin), own - buffer.stride);
  }
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
  return std::any_of(runs_.begin(), runs_.end(), [](const GridRun& run) { return run.damping != Damping::None; }) ||
         std::any_of(loose_.begin(), loose_.end(), isDamped);
}

}  // namespace muelle::engine::kernels
