#pragma once
#include "grader/run/workplace.h"

#include <optional>

namespace muelle::grader {

/// A folder with the precompiled header that a user without rights can get to, so that it can be mounted and need not
/// be copied into each sandbox: the build folder, or, when the checkout lies in a private home, a copy in the system's
/// temporary folder that belongs to us and that nobody else can write. nullopt when neither can be had.
std::optional<std::filesystem::path> sharedPrelude(const Workplace& workplace);

}  // namespace muelle::grader
