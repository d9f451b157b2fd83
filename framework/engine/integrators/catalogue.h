#pragma once
#include "engine/method.h"

#include <memory>
#include <string_view>
#include <vector>

namespace muelle::engine {

/// The ids of all methods, in the order in which tables and figures show them: explicit, implicit, position based.
const std::vector<std::string>& methodIds();

/// A method by its id ("velocity_verlet"); throws std::invalid_argument with the nearest known id.
std::unique_ptr<Method> makeMethod(std::string_view id);

/// The facts about a method by its id; throws as makeMethod.
const MethodInfo& methodInfo(std::string_view id);

}  // namespace muelle::engine
