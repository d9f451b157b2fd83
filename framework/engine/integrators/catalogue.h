#pragma once
#include "engine/integrator.h"

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace muelle::engine {

/// The ids of all methods, in the order in which tables and figures show them: explicit, implicit, position based.
const std::vector<std::string>& methodIds();

/// What to say of a word that is no method's id: "; here it is 'runge_kutta_4'" of "rk4" and of what else textbooks and
/// libraries call a method that is here, else "; did you mean ...?" or the ids that there are.
std::string methodSuggestion(const std::string& word);

/// A method by its id ("velocity_verlet"); throws std::invalid_argument with methodSuggestion().
std::unique_ptr<Integrator> makeMethod(std::string_view id);

/// The facts about a method by its id; throws as makeMethod.
const MethodInfo& methodInfo(std::string_view id);

}  // namespace muelle::engine
