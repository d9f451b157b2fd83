#pragma once
#include "course/manifest.h"

#include <filesystem>
#include <stdexcept>

namespace muelle {

/// The exercise whose file a submission's folder holds.
/// \param exercises the folder of the course's exercises   Throws std::runtime_error when it holds none.
inline Manifest manifestOf(const std::filesystem::path& submission, const std::filesystem::path& exercises) {
  for (const Manifest& manifest : readCourse(exercises)) {
    if (std::filesystem::exists(submission / manifest.files.front())) return manifest;
  }
  throw std::runtime_error(submission.string() + " holds no file of an exercise");
}

}  // namespace muelle
