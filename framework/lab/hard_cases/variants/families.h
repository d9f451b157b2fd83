#pragma once
/// \file
/// The variants of the hard cases by what they are about; together, in this order, allVariants().

#include "lab/hard_cases/variant.h"

#include <vector>

namespace muelle::hard_cases {

/// H01, H02, H03: one oscillator.
std::vector<Variant> oscillatorVariants();
/// H04 to H08: pendulums, and bodies that are free.
std::vector<Variant> bodyVariants();
/// H09 to H12: chains, and ratios of stiffness and mass.
std::vector<Variant> chainVariants();
/// H13, H14, H15: where the energy has no gradient, or no single way down.
std::vector<Variant> singularVariants();
/// H16: the corner-hung cloth, and stiffer ones.
std::vector<Variant> clothVariants();
/// H17 to H21: contact and friction.
std::vector<Variant> contactVariants();
/// H22, H23: a pulse, drag; H24: inputs that are refused.
std::vector<Variant> pulseAndDragVariants();

}  // namespace muelle::hard_cases
