#pragma once
#include "engine/kernels/instruction_set.h"
#include "engine/kernels/kernel_arguments.h"
#include "engine/kernels/precision.h"
#include "engine/kernels/spring_data.h"

#include <cstddef>
#include <string>
#include <vector>

namespace muelle::engine::kernels {

/// The case's nodes: components one after another, D numbers a node.
struct Nodes {
  int dimension = 3;
  std::vector<double> x, v;
  std::size_t count() const { return x.size() / static_cast<std::size_t>(dimension); }
};

/// Small random integers from a generator of its own, the same on every machine: numbers of the tests are exact.
class Dice {
 public:
  explicit Dice(unsigned seed) : state_(seed * 2654435761U + 1U) {}
  /// 0 to sides - 1.
  int roll(int sides) {
    state_ = state_ * 1664525U + 1013904223U;
    return static_cast<int>((state_ >> 8) % static_cast<unsigned>(sides));
  }
  /// In [-1, 1), a multiple of 2^-20.
  double number() { return (roll(1 << 21) - (1 << 20)) / 1048576.0; }

 private:
  unsigned state_;
};

constexpr Damping everyDamping[] = {Damping::None, Damping::Relative, Damping::Projected, Damping::Both};

/// Nodes in [-3, 3) at [-2, 2) each way.
Nodes randomNodes(int dimension, int count, Dice& dice);
/// A spring of random material with the damping of that form.
SpringData springOf(int a, int b, Damping damping, Dice& dice);
/// An n by n sheet in space with the springs of a cloth.
std::vector<SpringData> clothSprings(int n, Damping damping, Dice& dice);

/// Forces on all nodes in long double, by the definition of SpringData.
std::vector<long double> oracleForces(const Nodes& nodes, const std::vector<SpringData>& springs);

/// What rounding can do to a component of the force on each node, at most: see oracle.cpp.
std::vector<double> roundingBounds(const Nodes& nodes, const std::vector<SpringData>& springs);

/// Forces by the kernels of general topology, on padded lanes; D numbers a node. Padding is seen to stay 0.
std::vector<double> generalForces(const Nodes& nodes, const std::vector<SpringData>& springs);

/// Forces by the kernels of grids; the springs must be one. \param block nodes a block; 0: the usual
std::vector<double> gridForces(const Nodes& nodes, const std::vector<SpringData>& springs, std::size_t block = 0,
                               Precision precision = Precision::Double);

/// Runs what is given on every available instruction set in turn, and goes back to the first.
template <class Work>
void onEveryInstructionSet(Work work) {
  const InstructionSet before = instructionSet();
  for (const InstructionSet set : availableInstructionSets()) {
    useInstructionSet(set);
    work(std::string(nameOf(set)));
  }
  useInstructionSet(before);
}

/// Whether two lists have the same bits.
bool areSame(const std::vector<double>& a, const std::vector<double>& b);

/// x and v in planes, and what came out of them.
struct PlanarCase {
  explicit PlanarCase(const Nodes& nodes);
  PlanarState state() const { return {x.data(), v.data(), plane}; }
  /// Forces wanted, no drag, no gravity.
  PlanarFinish finish() { return {out.data(), plane, nullptr, v.data(), nullptr, nullptr, nullptr, {}}; }
  /// Component c of node i.
  double at(std::size_t i, std::size_t c) const { return out[c * plane + i]; }

  std::size_t plane;
  std::vector<double> x, v, out;
};

}  // namespace muelle::engine::kernels
