#pragma once
#include "grader/run/compile.h"
#include "grader/run/store.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace muelle::grader {

/// Where the student's parts of a kept object stand: beside it.
std::filesystem::path partsOf(const std::filesystem::path& object);

/// A kept object of a hand-in with the reference's functions in the place of some of the student's: linked when it is
/// asked for, and kept. Nothing when the tools fail or the exercise has no reference.
/// \param objectKey of the hand-in   \param object which of its objects, of the kind `build`
std::optional<std::filesystem::path> replacedObject(const Workplace& workplace, const Store& objects,
                                                    const Sandbox& sandbox, const Manifest& manifest,
                                                    const std::string& objectKey,
                                                    const std::vector<std::string>& functions,
                                                    const std::filesystem::path& object, Build build);

}  // namespace muelle::grader
