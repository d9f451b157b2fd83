/// \file
/// Spring kernels against the plain loop over springs, and against springs that are objects, in turns in one run, one
/// line each: the ratio of their times. "plain/grid" is the time of the plain loop over that of the grid's kernel;
/// "through the engine" that of steps of symplectic Euler, the plain loop's by hand over those of a simulation of the
/// built model with its checks. Times are those that the thread computed.

#include "cloth.h"
#include "pairs.h"
#include "plain_loop.h"
#include "steps.h"
#include "virtual_springs.h"

#include "engine/kernels/grid_search.h"
#include "engine/kernels/grid_springs.h"
#include "engine/kernels/spring_groups.h"

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <cstdint>
#include <cstdio>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>

namespace {

using namespace muelle::benchmarks;
namespace kernels = muelle::engine::kernels;

/// Numbers at a multiple of 64 bytes.
class Lanes {
 public:
  explicit Lanes(std::size_t count) : memory_(count + 8, 0.0) {}
  double* data() { return memory_.data() + (8 - reinterpret_cast<std::uintptr_t>(memory_.data()) / 8 % 8) % 8; }

 private:
  std::vector<double> memory_;
};

class Plain {
 public:
  explicit Plain(const Cloth& cloth) : x_(cloth.x), v_(cloth.v), f_(cloth.x.size()) {
    for (const auto& s : cloth.springs) {
      springs_.push_back({s.a, s.b, s.k, s.L0});
      damped_.push_back({s.a, s.b, s.k, s.L0, s.dProjected});
    }
  }
  void undamped(const PlainLoops& loops) {
    loops.undamped(springs_.data(), springs_.size(), x_.data(), f_.data(), f_.size());
  }
  void damped(const PlainLoops& loops) {
    loops.damped(damped_.data(), damped_.size(), x_.data(), v_.data(), f_.data(), f_.size());
  }

 private:
  std::vector<PlainSpring> springs_;
  std::vector<PlainDampedSpring> damped_;
  std::vector<double> x_, v_, f_;
};

class General {
 public:
  explicit General(const Cloth& cloth)
      : springs_(3, cloth.nodes, cloth.springs),
        lanes_(4 * static_cast<std::size_t>(cloth.nodes)),
        x_(lanes_),
        v_(lanes_),
        f_(lanes_) {
    for (std::size_t i = 0; i < cloth.x.size(); ++i) {
      x_.data()[i / 3 * 4 + i % 3] = cloth.x[i];
      v_.data()[i / 3 * 4 + i % 3] = cloth.v[i];
    }
  }
  void force() {
    std::fill(f_.data(), f_.data() + lanes_, 0.0);
    springs_.addForce(x_.data(), v_.data(), f_.data());
  }

 private:
  kernels::SpringGroups springs_;
  std::size_t lanes_;
  Lanes x_, v_, f_;
};

class Grid {
 public:
  explicit Grid(const Cloth& cloth, kernels::Precision precision = kernels::Precision::Double)
      : nodes_(static_cast<std::size_t>(cloth.nodes)),
        plane_(kernels::planeFor(nodes_)),
        x_(3 * plane_),
        v_(3 * plane_),
        f_(3 * plane_) {
    kernels::GridSearch found = kernels::findRuns(3, nodes_, cloth.springs);
    if (!found.isGrid()) throw std::logic_error(found.refusal);
    springs_ = std::make_unique<kernels::GridSprings>(3, nodes_, found.runs, found.loose, 0, precision);
    for (std::size_t i = 0; i < cloth.x.size(); ++i) {
      x_.data()[i % 3 * plane_ + i / 3] = cloth.x[i];
      v_.data()[i % 3 * plane_ + i / 3] = cloth.v[i];
    }
  }
  void force() {
    springs_->evaluate({x_.data(), v_.data(), plane_},
                       {f_.data(), plane_, nullptr, v_.data(), nullptr, nullptr, nullptr, {}});
  }

 private:
  std::size_t nodes_, plane_;
  std::unique_ptr<kernels::GridSprings> springs_;
  Lanes x_, v_, f_;
};

/// Prints a line for each comparison: ratio of times, the interval of its median, what it should be, both times.
class Table final : public benchmark::BenchmarkReporter {
 public:
  bool ReportContext(const Context&) override {
    fmt::print("{:<52} {:>6}  {:<14} {:>7}  {}\n", "times", "ratio", "interval", "bar",
               "ns a spring, first and second");
    return true;
  }
  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs) {
      if (run.error_occurred) {
        fmt::print("{:<52} {}\n", run.run_name.function_name, run.error_message);
        continue;
      }
      const auto of = [&](const char* name) { return run.counters.at(name).value; };
      const double bar = of("bar");
      const std::string bound = bar > 0.0   ? fmt::format(">= {:.2f}", bar)
                                : bar < 0.0 ? fmt::format("<= {:.2f}", -bar)
                                            : "";
      fmt::print("{:<52} {:6.2f}  {:5.2f} to {:5.2f} {:>7}  {:.2f} {:.2f}\n", run.run_name.function_name, of("ratio"),
                 of("from"), of("to"), bound, of("ns_first"), of("ns_second"));
      std::fflush(stdout);
    }
  }
};

/// \param bar what the ratio should be at least; negative: at most, without the sign; 0: nothing is asked for
void add(const std::string& name, std::size_t springs, double bar, std::function<Ratio()> run) {
  benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& state) {
    for (auto _ : state) {
      const Ratio ratio = run();
      const double each = 1e9 / static_cast<double>(springs);
      state.counters["ratio"] = ratio.median;
      state.counters["from"] = ratio.low;
      state.counters["to"] = ratio.high;
      state.counters["bar"] = bar;
      state.counters["ns_first"] = ratio.first * each;
      state.counters["ns_second"] = ratio.second * each;
    }
  })->Iterations(1);
}

/// Bars of the three sizes.
struct Bars {
  double general[3], grid[3];
};
Bars barsOf(kernels::InstructionSet set, bool damped) {
  if (set == kernels::InstructionSet::Baseline) return {{1.25, 1.15, 1.25}, {1.7, 1.6, 1.6}};
  if (damped) return {{1.9, 1.5, 1.4}, {3.5, 3.0, 2.4}};
  return {{1.9, 1.6, 1.5}, {3.0, 2.5, 2.2}};
}

template <class Kernel>
std::function<Ratio()> againstPlain(int n, bool damped, kernels::InstructionSet set, bool isRenumbered) {
  return [=] {
    kernels::useInstructionSet(set);
    const PlainLoops loops = plainLoops(set);
    const Cloth cloth = makeCloth(n, damped);
    Plain plain(cloth);
    Kernel kernel(isRenumbered ? renumbered(cloth) : cloth);
    const auto plainCall = [&] { damped ? plain.damped(loops) : plain.undamped(loops); };
    return ratioOfTimes(plainCall, [&] { kernel.force(); });
  };
}

/// \param isGrid nodes in their order, in which the program finds a grid; else shuffled
std::function<Ratio()> stepsAgainstPlain(int n, bool damped, kernels::InstructionSet set, bool isGrid) {
  return [=] {
    kernels::useInstructionSet(set);
    const Cloth cloth = makeCloth(n, damped);
    PlainSteps plain(cloth, damped, plainLoops(set));
    EngineSteps engine(isGrid ? cloth : shuffled(cloth));
    return ratioOfTimes([&] { plain.step(); }, [&] { engine.step(); });
  };
}

std::function<Ratio()> singleAgainstDouble(int n, bool damped, kernels::InstructionSet set) {
  return [=] {
    kernels::useInstructionSet(set);
    const Cloth cloth = makeCloth(n, damped);
    Grid full(cloth), single(cloth, kernels::Precision::Single);
    return ratioOfTimes([&] { full.force(); }, [&] { single.force(); });
  };
}

constexpr int sides[3] = {32, 256, 1024};

void addAll() {
  for (const kernels::InstructionSet set : kernels::availableInstructionSets()) {
    for (const bool damped : {false, true}) {
      const Bars bars = barsOf(set, damped);
      for (std::size_t i = 0; i < 3; ++i) {
        const auto count = static_cast<std::size_t>(6 * sides[i] * sides[i]);
        const std::string tail =
            fmt::format("{}/{}/{}", kernels::nameOf(set), damped ? "damped" : "undamped", sides[i]);
        add("plain/general/" + tail, count, bars.general[i], againstPlain<General>(sides[i], damped, set, true));
        add("plain/grid/" + tail, count, bars.grid[i], againstPlain<Grid>(sides[i], damped, set, false));
        add("grid, double/single/" + tail, count, set == kernels::InstructionSet::Baseline ? 0.0 : 1.7,
            singleAgainstDouble(sides[i], damped, set));
        add("plain/general, through the engine/" + tail, count, 0.0, stepsAgainstPlain(sides[i], damped, set, false));
        add("plain/grid, through the engine/" + tail, count, 0.0, stepsAgainstPlain(sides[i], damped, set, true));
      }
    }
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const int n = sides[i];
    const auto count = static_cast<std::size_t>(6 * n * n);
    add(fmt::format("plain/grid of many materials/{}", n), count, 0.0, [=] {
      const kernels::InstructionSet set = kernels::availableInstructionSets().back();
      kernels::useInstructionSet(set);
      Cloth cloth = makeCloth(n, false);
      for (std::size_t s = 0; s < cloth.springs.size(); ++s) cloth.springs[s].k += static_cast<double>(s % 7);
      Plain plain(cloth);
      Grid grid(cloth);
      return ratioOfTimes([&] { plain.undamped(plainLoops(set)); }, [&] { grid.force(); });
    });
    add(fmt::format("shuffled/sorted/{}", n), count, -1.2, [=] {
      kernels::useInstructionSet(kernels::availableInstructionSets().back());
      const Cloth cloth = makeCloth(n, false);
      General sorted(renumbered(cloth)), mixed(renumbered(shuffled(cloth)));
      return ratioOfTimes([&] { mixed.force(); }, [&] { sorted.force(); });
    });
    for (const bool scattered : {false, true}) {
      const double bar = scattered ? (n == 32 ? 3.0 : 8.0) : 2.5;
      add(fmt::format("objects {}/grid/{}", scattered ? "scattered" : "in order", n), count, bar, [=] {
        kernels::useInstructionSet(kernels::availableInstructionSets().back());
        const Cloth cloth = makeCloth(n, false);
        const VirtualSprings objects(cloth, scattered);
        std::vector<double> f(cloth.x.size());
        Grid grid(cloth);
        return ratioOfTimes([&] { objects.force(cloth.x.data(), f.data(), f.size()); }, [&] { grid.force(); });
      });
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  addAll();
  Table table;
  benchmark::RunSpecifiedBenchmarks(&table);
  benchmark::Shutdown();
  return 0;
}
