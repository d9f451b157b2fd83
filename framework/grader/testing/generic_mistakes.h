#pragma once
/// \file
/// Mistakes that any function may hold. Nobody lists them: they follow from the oracle and from the types of its
/// arguments. Each predicts what a function with that mistake returns.
///
/// | id | the function gives |
/// |---|---|
/// | wrong_sign, doubled, halved | the right numbers times -1, 2, 1/2 |
/// | absolute_value, always_negative | their sizes, with one sign |
/// | rope | the right numbers, but 0 for the negative (value -1) or the positive ones (value 1) |
/// | missing_component, component_sign | the right numbers but one |
/// | cut_result | the right numbers cut to whole ones |
/// | ignored, missing_factor, constant_argument | what the oracle gives with 0, 1, or another constant for an argument
/// | | argument_sign, argument_size, doubled_argument, halved_argument, squared, whole_numbers | ... with -p, |p|, 2p,
/// p/2, p^2, trunc(p) | | swapped_arguments, argument_twice | ... with two of one type exchanged, or one of them for
/// both | | factor_too_many, factor_too_few, multiplied_for_divided, divided_for_multiplied | ... times p, 1/p, p^2,
/// 1/p^2 | | first_skipped, last_skipped, first_only, last_only, first_for_all | ... with a part of a list |

#include "grader/testing/call_history.h"

namespace muelle::grader {

/// A mistake and what it predicts for a call of the history.
struct Prediction {
  Hypothesis hypothesis;
  std::function<std::vector<double>(std::size_t call)> numbers;
};

/// The mistakes that the function of a history may hold, those that its exercise lists first. The history outlives
/// them.
std::vector<Prediction> predictionsOf(const CallHistoryBase& history);

}  // namespace muelle::grader
