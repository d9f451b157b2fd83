/// \file
/// What a step costs beside the force: each method against a loop written by hand for it and the same force, in turns
/// in one run, medians of the ratios of pairs with the interval of the median. At 3 unknowns (a spring pendulum) the
/// ratio of the two times; at 300 (a chain of 100 nodes) the method's time less that of its forces, in parts of the
/// plain force, per evaluation.
///
/// Each pair has its arrays elsewhere in memory: whether two of them lie a multiple of 4 KiB apart, or begin a line of
/// the cache, is worth a tenth, and is luck. So is where the program itself lies, by whose addresses the processor
/// tells its loads and branches apart: at 3 unknowns that is worth a third, so that the pairs are those of several
/// processes.

#include "engine/integrators/catalogue.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <functional>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using namespace muelle;

struct Spring {
  std::size_t a, b;
  double k, L0, d;
};

/// Masses of 1 in a chain, the first of whose springs is tied to the origin: the plain index loop over springs.
struct Chain {
  std::size_t nodes;
  bool damped;
  std::vector<Spring> springs;
  Chain(std::size_t n, bool isDamped) : nodes(n), damped(isDamped) {
    for (std::size_t i = 1; i < n; ++i) springs.push_back({i - 1, i, 100.0, 0.9, 0.1});
  }
  /// The origin's spring aside, with which the accelerations begin.
  void operator()(const double* x, const double* v, double* a) const {
    for (std::size_t i = 0; i < nodes; ++i) {
      a[3 * i] = a[3 * i + 1] = 0.0;
      a[3 * i + 2] = -9.81;
    }
    const double length = std::sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]), pull = 100.0 * (1.0 - 0.9 / length);
    for (std::size_t c = 0; c < 3; ++c) a[c] -= pull * x[c];
    for (const Spring& spring : springs) {
      const double* xa = x + 3 * spring.a;
      const double* xb = x + 3 * spring.b;
      const double d[3] = {xb[0] - xa[0], xb[1] - xa[1], xb[2] - xa[2]};
      const double squared = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
      const double L = std::sqrt(squared);
      double s = spring.k * (1.0 - spring.L0 / L);
      if (damped) {
        const double* va = v + 3 * spring.a;
        const double* vb = v + 3 * spring.b;
        s += spring.d * (d[0] * (vb[0] - va[0]) + d[1] * (vb[1] - va[1]) + d[2] * (vb[2] - va[2])) / squared;
      }
      for (std::size_t c = 0; c < 3; ++c) {
        a[3 * spring.a + c] += s * d[c];
        a[3 * spring.b + c] -= s * d[c];
      }
    }
  }
};

class System final : public engine::DynamicalSystem {
 public:
  System(std::size_t nodes, bool damped) : chain_(nodes, damped), mass_(3 * nodes, 1.0) {}
  int size() const override { return static_cast<int>(mass_.size()); }
  std::span<const double> mass() const override { return mass_; }
  std::span<const double> inverseMass() const override { return mass_; }
  bool forceUsesVelocity() const override { return chain_.damped; }
  void force(double, In x, In v, In, Out f) const override { chain_(x.data(), v.data(), f.data()); }
  void acceleration(double, In x, In v, In, Out a) const override { chain_(x.data(), v.data(), a.data()); }
  const Chain& chain() const { return chain_; }

 private:
  Chain chain_;
  std::vector<double> mass_;
};

State startOf(std::size_t nodes) {
  State state;
  for (std::size_t i = 0; i < nodes; ++i) {
    const double s = static_cast<double>(i + 1);
    state.x.insert(state.x.end(), {0.9 * s, 0.1 * std::sin(s), -0.2});
    state.v.insert(state.v.end(), {0.0, 0.3, 0.1 * std::cos(s)});
  }
  return state;
}

/// Of this thread's own time: a machine that is shared takes turns with others.
double now() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

double seconds(const std::function<void()>& work) {
  const double start = now();
  work();
  return now() - start;
}

constexpr int pairs = 21, processes = 9;

/// The median, and the interval in which the true one lies in 95 of 100 cases.
struct Median {
  double value, low, high;
};
Median median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const auto n = static_cast<double>(values.size());
  const auto reach = static_cast<std::size_t>(std::ceil(0.98 * std::sqrt(n)));
  const std::size_t middle = values.size() / 2;
  return {values[middle], values[middle - reach], values[middle + reach]};
}

constexpr const char* large[] = {"symplectic_euler", "velocity_verlet", "runge_kutta_4", "takahashi_imada",
                                 "dop853",           "rkn64",           "nystrom8",      "nystrom12"};

/// What pairs of one comparison gave: ratio of times, and both times [ns].
struct Pairs {
  std::vector<double> ratios, ours, others;
};
/// By the comparison's name.
using Results = std::map<std::string, Pairs>;

/// Memory that moves what is allocated after it, by another distance for each pair.
std::vector<double> gap(int pair) { return std::vector<double>(static_cast<std::size_t>(pair * 37 % 509)); }

/// The same of the stack: runs the work in a place of its own.
void elsewhere(int pair, const std::function<void()>& work) {
  auto* const unused = static_cast<volatile char*>(__builtin_alloca(static_cast<std::size_t>(pair * 592 % 4093 + 16)));
  unused[0] = 0;
  work();
}

/// `steps` steps of a method by hand; N lanes, 0: as many as the arrays have.
template <std::size_t N>
struct ByHand {
  const Chain& chain;
  std::vector<double> x, v, a;
  std::vector<double> stage, k[4];
  explicit ByHand(const Chain& c, const State& s) : chain(c), x(s.x), v(s.v), a(s.x.size()), stage(s.x.size()) {
    for (auto& array : k) array.resize(s.x.size());
    chain(x.data(), v.data(), a.data());
  }
  std::size_t size() const { return N > 0 ? N : x.size(); }

  void symplectic_euler(double h) {
    chain(x.data(), v.data(), a.data());
    for (std::size_t i = 0; i < size(); ++i) {
      v[i] += h * a[i];
      x[i] += h * v[i];
    }
  }
  void velocity_verlet(double h) {
    for (std::size_t i = 0; i < size(); ++i) {
      v[i] += 0.5 * h * a[i];
      x[i] += h * v[i];
    }
    chain(x.data(), v.data(), a.data());
    for (std::size_t i = 0; i < size(); ++i) v[i] += 0.5 * h * a[i];
  }
  void runge_kutta_4(double h) {
    chain(x.data(), v.data(), k[0].data());
    for (std::size_t i = 0; i < size(); ++i) stage[i] = x[i] + 0.5 * h * v[i];
    chain(stage.data(), v.data(), k[1].data());
    for (std::size_t i = 0; i < size(); ++i) stage[i] = x[i] + 0.5 * h * (v[i] + 0.5 * h * k[0][i]);
    chain(stage.data(), v.data(), k[2].data());
    for (std::size_t i = 0; i < size(); ++i) stage[i] = x[i] + h * (v[i] + 0.5 * h * k[1][i]);
    chain(stage.data(), v.data(), k[3].data());
    for (std::size_t i = 0; i < size(); ++i) {
      x[i] += h * (v[i] + h / 6.0 * (k[0][i] + k[1][i] + k[2][i]));
      v[i] += h / 6.0 * (k[0][i] + 2.0 * (k[1][i] + k[2][i]) + k[3][i]);
    }
  }
};

/// One pair; its ratio is our time over the loop's.
template <std::size_t Nodes>
void byHand(const char* id, void (ByHand<3 * Nodes>::*handStep)(double)) {
  const System system(Nodes, false);
  const double h = 1e-3;
  const int steps = 10000;
  const auto method = engine::makeMethod(id);
  method->prepare(system, {});
  State state = startOf(Nodes), next = state;
  State *from = &state, *to = &next;
  ByHand<3 * Nodes> hand(system.chain(), state);
  const double ours = seconds([&] {
    for (int n = 0; n < steps; ++n) {
      method->step(system, *from, h, *to);
      method->accept();
      std::swap(from, to);
    }
  });
  const double plain = seconds([&] {
    for (int n = 0; n < steps; ++n) (hand.*handStep)(h);
  });
  if (std::abs(hand.x[0] - from->x[0]) > 1e-9) throw std::logic_error(fmt::format("{}: not the same motion", id));
  fmt::print("small {} {} {} {}\n", id, ours / plain, 1e9 * ours / steps, 1e9 * plain / steps);
}

/// One pair; its ratio is our time less the forces', over the forces'.
void besideTheForce(const char* id) {
  const System system(100, !engine::methodInfo(id).needs.velocityFreeForce);
  const double h = 1e-3;
  const auto method = engine::makeMethod(id);
  method->prepare(system, {});
  State state = startOf(100), next = state;
  State *from = &state, *to = &next;
  const double ours = seconds([&] {
    for (int n = 0; n < 200; ++n) {
      method->step(system, *from, h, *to);
      method->accept();
      std::swap(from, to);
    }
  });
  const auto evaluations = method->work().forceEvaluations;
  std::vector<double> a(300);
  const double force = seconds([&] {
    for (long long n = 0; n < evaluations; ++n) system.acceleration(0.0, state.x, state.v, state.z, a);
  });
  const double each = 1e9 / static_cast<double>(evaluations);
  fmt::print("large {} {} {} {}\n", id, ours / force - 1.0, each * (ours - force), each * force);
}

/// What a process of its own does: a line for each pair.
void measure() {
  for (int p = 0; p < pairs; ++p) {
    const std::vector<double> unused = gap(p);
    elsewhere(p, [] {
      byHand<1>("symplectic_euler", &ByHand<3>::symplectic_euler);
      byHand<1>("velocity_verlet", &ByHand<3>::velocity_verlet);
      byHand<1>("runge_kutta_4", &ByHand<3>::runge_kutta_4);
      for (const char* id : large) besideTheForce(id);
    });
  }
}

/// What the pairs of a process gave.
void collect(const std::string& program, Results& results) {
  FILE* const lines = popen((program + " pairs").c_str(), "r");
  if (lines == nullptr) throw std::runtime_error("cannot start " + program);
  char size[16], id[64];
  double ratio, ours, other;
  while (std::fscanf(lines, "%15s %63s %lf %lf %lf", size, id, &ratio, &ours, &other) == 5) {
    Pairs& all = results[fmt::format("{} {}", size, id)];
    all.ratios.push_back(ratio);
    all.ours.push_back(ours);
    all.others.push_back(other);
  }
  if (pclose(lines) != 0) throw std::runtime_error("a process that measures has failed");
}

}  // namespace

int main(int argc, char** argv) {
  if (argc > 1) return measure(), 0;
  Results results;
  for (int i = 0; i < processes; ++i) collect(argv[0], results);
  for (const char* id : {"symplectic_euler", "velocity_verlet", "runge_kutta_4"}) {
    const Pairs& all = results.at(fmt::format("small {}", id));
    const Median ratio = median(all.ratios);
    fmt::print("   3 unknowns {:<18} {:.2f} ({:.2f} to {:.2f}) x the loop by hand; {:.1f} ns a step\n", id, ratio.value,
               ratio.low, ratio.high, median(all.ours).value);
  }
  for (const char* id : large) {
    const Pairs& all = results.at(fmt::format("large {}", id));
    const Median ratio = median(all.ratios);
    fmt::print(
        " 300 unknowns {:<18} {:.2f} ({:.2f} to {:.2f}) of the plain force ({:.0f} ns) beside it, {:.0f} ns an "
        "evaluation\n",
        id, ratio.value, ratio.low, ratio.high, median(all.others).value, median(all.ours).value);
  }
}
