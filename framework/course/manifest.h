#pragma once
#include "course/time_limits.h"

#include <filesystem>
#include <string>
#include <vector>

namespace muelle {

/// How much a student is told about a failed hidden test.
enum class FeedbackLevel {
  Criterion,  ///< only that the criterion failed, and its hint
  Property,   ///< and the sentence of the test that failed
  Values,     ///< and the call, what came back and what was expected
};

/// One line of the rubric: a suite of the hidden tests.
struct Criterion {
  std::string name;   ///< shown: "Hooke's force on both nodes"
  std::string suite;  ///< GoogleTest suite: "HookeForce"
  double points = 0.0;
  bool partial = false;                ///< points in proportion to the tests passed; otherwise all or nothing
  std::string hint;                    ///< one sentence: where to look
  std::vector<std::string> functions;  ///< the student's functions it judges
  /// Those on which they are built: where one of these alone is wrong, the criterion is earned all the same.
  std::vector<std::string> follows{};
};

/// A usual mistake, named in the first line of the feedback when the numbers are exactly what it gives.
struct Misconception {
  std::string id;        ///< "wrong_sign"
  std::string function;  ///< the function that shows it
  std::string says;      ///< first line of the feedback: names the mistake
  std::string hint;      ///< how to mend it
};

/// What a student is asked before the demo runs for the first time, for no points: "does the swing keep its height?"
struct Prediction {
  std::string question;              ///< "" when nothing is asked
  std::vector<std::string> answers;  ///< from which one is chosen
};

/// What exercises/TOPIC/exercise.toml says.
struct Manifest {
  std::string topic;  ///< the folder's name: "spring_1d"
  int order = 0;      ///< place in the course
  std::string title;
  double points = 0.0;             ///< the sum of the criteria's
  std::vector<std::string> files;  ///< what is handed in: "spring_1d.cpp"
  FeedbackLevel feedback = FeedbackLevel::Values;
  int callSeconds = usualCallSeconds;  ///< processor time that one call of the student's may take [s]
  std::vector<std::string> slides;     ///< titles of the lecture's slides
  std::vector<Criterion> criteria;
  std::vector<Misconception> misconceptions;
  Prediction predict;
};

/// Reads one manifest. Throws std::runtime_error with file, line, key, what was expected and the nearest known key.
Manifest readManifest(const std::filesystem::path& file);

/// Reads every manifest below `exercises`, in course order. A folder without exercise.toml is no exercise.
std::vector<Manifest> readCourse(const std::filesystem::path& exercises);

/// The exercise of that topic; throws std::runtime_error naming the nearest topic when there is none.
const Manifest& findExercise(const std::vector<Manifest>& course, const std::string& topic);

}  // namespace muelle
