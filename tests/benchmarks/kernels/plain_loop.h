#pragma once
/// \file
/// What a user would write: one loop over springs, three numbers a node. Compiled with the same flags as the kernels of
/// each instruction set.

#include "engine/kernels/instruction_set.h"

#include <cstddef>

namespace muelle::benchmarks {

/// A spring with no more than it needs.
struct PlainSpring {
  int a, b;
  double k, L0;
};
struct PlainDampedSpring {
  int a, b;
  double k, L0, d;  ///< d is projected
};

/// Sets f to the forces of all springs.
struct PlainLoops {
  void (*undamped)(const PlainSpring* springs, std::size_t count, const double* x, double* f, std::size_t numbers);
  void (*damped)(const PlainDampedSpring* springs, std::size_t count, const double* x, const double* v, double* f,
                 std::size_t numbers);
};

PlainLoops plainBaseline();
PlainLoops plainAvx2();
PlainLoops plainAvx512();

inline PlainLoops plainLoops(engine::kernels::InstructionSet set) {
  using engine::kernels::InstructionSet;
  return set == InstructionSet::Avx512 ? plainAvx512() : set == InstructionSet::Avx2 ? plainAvx2() : plainBaseline();
}

}  // namespace muelle::benchmarks
