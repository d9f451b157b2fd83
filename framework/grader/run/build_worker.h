#pragma once
#include "grader/run/keys.h"
#include "grader/run/store.h"
#include "grader/verdict.h"

namespace muelle::grader {

/// A hand-in's shared object, or why there is none.
struct BuiltObject {
  BuildOutcome outcome;
  std::filesystem::path plain;      ///< what the criteria are judged with
  std::filesystem::path sanitised;  ///< for the second look; empty when nothing asks for one
  std::filesystem::path refilled;   ///< the same with another fill; empty when nothing asks for it
};

/// What one attempt to build says.
struct BuildAttempt {
  BuiltObject object;
  /// Something died or passed a wide limit: to be tried once more, with nothing else running, before it is believed.
  bool isDoubtful = false;
  bool wasStarted = false;  ///< a compiler was
};

/// Compiles and links a hand-in in the sandbox, unless that is kept. What is certain is kept; a fault of ours and what
/// is doubtful are not.
/// \param isLastTry believes the second death of a tool when a known good file compiles at the same time
BuildAttempt buildObject(const Workplace& workplace, const Store& store, const Manifest& manifest,
                         const Sources& sources, const Sandbox& sandbox, const GradeOptions& options, bool isLastTry);

}  // namespace muelle::grader
