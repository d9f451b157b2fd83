#pragma once
#include "engine/kernels/spring_data.h"

#include <cstddef>
#include <vector>

namespace muelle::engine::kernels {

/// The springs i -> i + stride of one damping form, for i from `begin` up to `end`, without those at the gaps.
struct GridRun {
  std::size_t stride = 1;
  Damping damping = Damping::None;
  std::size_t begin = 0, end = 0;
  std::vector<std::size_t> gaps;  ///< ascending: no spring begins here
  bool isConstant = true;         ///< one material for all: then the arrays have one entry, else end - begin
  std::vector<double> k, L0;      ///< [N/m], [m]
  std::vector<double> dRelative;  ///< [kg/s]; empty where the form has none
  std::vector<double> dProjected;

  std::size_t springs() const { return end - begin - gaps.size(); }
};

}  // namespace muelle::engine::kernels
