#include "virtual_springs.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

namespace muelle::benchmarks {

class VirtualSprings::Element {
 public:
  virtual ~Element() = default;
  virtual void apply(const double* x, double* f) const = 0;
};

class VirtualSprings::Spring final : public Element {
 public:
  explicit Spring(const engine::kernels::SpringData& s) : a_(s.a), b_(s.b), k_(s.k), L0_(s.L0) {}
  void apply(const double* x, double* f) const override {
    double d[3], square = 0.0;
    for (int c = 0; c < 3; ++c) {
      d[c] = x[3 * a_ + c] - x[3 * b_ + c];
      square += d[c] * d[c];
    }
    const double L = std::sqrt(square);
    const double ratio = -k_ * ((L - L0_) / L);
    for (int c = 0; c < 3; ++c) {
      f[3 * a_ + c] += ratio * d[c];
      f[3 * b_ + c] -= ratio * d[c];
    }
  }

 private:
  int a_, b_;
  double k_, L0_;
};

VirtualSprings::VirtualSprings(const Cloth& cloth, bool scattered) {
  std::mt19937 random(3);
  std::uniform_int_distribution<std::size_t> size(16, 200);
  std::vector<std::size_t> order(cloth.springs.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  if (scattered) std::shuffle(order.begin(), order.end(), random);
  elements_.resize(order.size());
  for (const std::size_t i : order) {
    elements_[i] = std::make_unique<Spring>(cloth.springs[i]);
    if (scattered) between_.push_back(std::make_unique<char[]>(size(random)));
  }
}

VirtualSprings::~VirtualSprings() = default;

void VirtualSprings::force(const double* x, double* f, std::size_t numbers) const {
  std::fill(f, f + numbers, 0.0);
  for (const auto& element : elements_) element->apply(x, f);
}

}  // namespace muelle::benchmarks
