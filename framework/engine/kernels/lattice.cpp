#include "engine/kernels/lattice.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

namespace muelle::engine::kernels {

namespace {

using Vector3 = std::array<double, 3>;
using Steps = std::array<long, 3>;

constexpr double tolerance = 0.01;           // of a step
constexpr std::size_t mostVectors = 40;      // of springs, of different direction or length
constexpr double largestSteps = 1000000000;  // in one direction

double dot(const Vector3& a, const Vector3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vector3 minus(const Vector3& a, const Vector3& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Vector3 reduced(const Vector3& a, double factor, const Vector3& b) {
  return {a[0] - factor * b[0], a[1] - factor * b[1], a[2] - factor * b[2]};
}
Vector3 point(int dimension, std::span<const double> x, std::size_t i) {
  const auto D = static_cast<std::size_t>(dimension);
  Vector3 p = {};
  for (std::size_t c = 0; c < D; ++c) p[c] = x[D * i + c];
  return p;
}

/// Independent vectors, and beside them the same ones orthogonalised one after another (Gram-Schmidt).
class Basis {
 public:
  /// Takes the vector when it points out of what is spanned so far.
  void offer(const Vector3& vector) {
    Vector3 rest = vector;
    for (std::size_t k = 0; k < vectors_.size(); ++k) {
      rest = reduced(rest, dot(rest, orthogonal_[k]) / dot(orthogonal_[k], orthogonal_[k]), orthogonal_[k]);
    }
    if (vectors_.size() == 3 || dot(rest, rest) <= 0.0025 * dot(vector, vector)) return;
    vectors_.push_back(vector);
    orthogonal_.push_back(rest);
  }

  /// The whole multiples that add up to the vector; nothing where there are none.
  std::optional<Steps> stepsTo(Vector3 vector) const {
    Steps steps = {};
    for (std::size_t k = vectors_.size(); k-- > 0;) {
      const double count = dot(vector, orthogonal_[k]) / dot(orthogonal_[k], orthogonal_[k]);
      const double whole = std::round(count);
      if (!(std::abs(count - whole) <= tolerance && std::abs(whole) <= largestSteps)) return std::nullopt;
      steps[k] = static_cast<long>(whole);
      vector = reduced(vector, whole, vectors_[k]);
    }
    if (vectors_.empty() || dot(vector, vector) > tolerance * tolerance * dot(vectors_[0], vectors_[0])) {
      return std::nullopt;
    }
    return steps;
  }

 private:
  std::vector<Vector3> vectors_, orthogonal_;
};

/// The vectors of the springs, one of each kind and its opposite, shortest first; empty where there are too many.
std::vector<Vector3> vectorsOf(int dimension, std::span<const double> x, std::span<const SpringData> springs) {
  std::vector<Vector3> kinds;
  for (const SpringData& s : springs) {
    const Vector3 d =
        minus(point(dimension, x, static_cast<std::size_t>(s.b)), point(dimension, x, static_cast<std::size_t>(s.a)));
    const double size = dot(d, d);
    if (!(size > 0.0)) continue;
    const bool isKnown = std::any_of(kinds.begin(), kinds.end(), [&](const Vector3& kind) {
      const Vector3 one = minus(kind, d), other = reduced(kind, -1.0, d);
      return std::min(dot(one, one), dot(other, other)) <= tolerance * tolerance * size;
    });
    if (isKnown) continue;
    if (kinds.size() == mostVectors) return {};
    kinds.push_back(d);
  }
  std::sort(kinds.begin(), kinds.end(), [](const Vector3& a, const Vector3& b) { return dot(a, a) < dot(b, b); });
  return kinds;
}

/// Places from steps; nothing where two nodes have the same, or the box is more than half empty.
LatticePlaces numbered(const std::vector<Steps>& steps) {
  Steps low = steps.front(), high = steps.front();
  for (const Steps& s : steps) {
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], s[k]);
      high[k] = std::max(high[k], s[k]);
    }
  }
  std::array<std::size_t, 3> axes = {0, 1, 2};
  const auto side = [&](std::size_t k) { return high[k] - low[k] + 1; };
  std::stable_sort(axes.begin(), axes.end(), [&](std::size_t a, std::size_t b) { return side(a) < side(b); });
  double volume = 1.0;
  for (const std::size_t k : axes) volume *= static_cast<double>(side(k));
  if (volume > 2.0 * static_cast<double>(steps.size()) || volume > std::numeric_limits<int>::max()) return {};
  LatticePlaces result;
  result.places = static_cast<std::size_t>(volume);
  std::vector<char> isTaken(result.places);
  for (const Steps& s : steps) {
    long place = 0;
    for (std::size_t k = 3; k-- > 0;) place = place * side(axes[k]) + s[axes[k]] - low[axes[k]];
    if (isTaken[static_cast<std::size_t>(place)]++) return {};
    result.place.push_back(static_cast<int>(place));
  }
  return result;
}

}  // namespace

LatticePlaces placesOnLattice(int dimension, std::span<const double> x, std::span<const SpringData> springs) {
  const std::vector<Vector3> vectors = vectorsOf(dimension, x, springs);
  if (vectors.empty()) return {};
  Basis basis;
  for (const Vector3& vector : vectors) basis.offer(vector);
  const bool areMultiples =
      std::all_of(vectors.begin(), vectors.end(), [&](const Vector3& v) { return basis.stepsTo(v).has_value(); });
  if (!areMultiples) return {};
  std::vector<Steps> steps;
  const Vector3 origin = point(dimension, x, 0);
  for (std::size_t i = 0; i < x.size() / static_cast<std::size_t>(dimension); ++i) {
    const std::optional<Steps> own = basis.stepsTo(minus(point(dimension, x, i), origin));
    if (!own) return {};
    steps.push_back(*own);
  }
  return numbered(steps);
}

}  // namespace muelle::engine::kernels
