#pragma once
#include "course/manifest.h"
#include "grader/run/workplace.h"

#include <algorithm>
#include <filesystem>
#include <vector>

namespace muelle::grader {

/// The exercises that a build has: it may have been configured for some alone (MUELLE_TOPICS).
class BuiltExercises {
 public:
  explicit BuiltExercises(const Workplace& workplace) : exercises_(readCourse(workplace.exercises())) {
    std::erase_if(exercises_,
                  [&](const Manifest& each) { return !std::filesystem::exists(workplace.hiddenProgram(each.topic)); });
  }

  const std::vector<Manifest>& all() const { return exercises_; }

  /// Whether a submission's folder holds the file of one of them.
  bool haveOneOf(const std::filesystem::path& submission) const {
    return std::ranges::any_of(exercises_, [&submission](const Manifest& each) {
      return std::filesystem::exists(submission / each.files.front());
    });
  }

 private:
  std::vector<Manifest> exercises_;
};

}  // namespace muelle::grader
