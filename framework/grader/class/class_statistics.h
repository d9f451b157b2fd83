#pragma once
#include "grader/class/graded_class.h"

#include <optional>
#include <string>
#include <vector>

namespace muelle::grader {

/// How the class did in one exercise.
struct ExerciseStatistics {
  int handedIn = 0;              ///< students whose file was there
  std::optional<double> median;  ///< of the students with points for it, 0 for what was not handed in
};

/// How the class did in one criterion.
struct CriterionStatistics {
  std::string topic;
  std::string name;
  int judged = 0;  ///< students whose file was built and who have points for it
  int passed = 0;  ///< of these, with full marks
  double share() const { return static_cast<double>(passed) / judged; }
};

/// A named mistake of one exercise.
struct MistakeStatistics {
  std::string topic;
  std::string id;
  std::string says;  ///< the manifest's words; "" when it has none
  int students = 0;  ///< who made it, in however many criteria
};

/// What the reports of a class say about all of it. A student without points is left out of the medians.
struct ClassStatistics {
  std::optional<double> median;               ///< of the total points
  std::vector<ExerciseStatistics> exercises;  ///< one for each of the course
  std::vector<CriterionStatistics> criteria;  ///< those that not everybody passed, the lowest share first
  std::vector<MistakeStatistics> mistakes;    ///< the commonest first
};

ClassStatistics statisticsOf(const GradedClass& graded);

/// Ids of the mistakes that were named for one criterion, each once. Empty when it has full marks or no score.
std::vector<std::string> mistakesOf(const Criterion& criterion, const GradedExercise& exercise);

}  // namespace muelle::grader
