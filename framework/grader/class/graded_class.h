#pragma once
#include "grader/authors/unnamed_groups.h"
#include "grader/verdict.h"

#include <optional>
#include <string>
#include <vector>

namespace muelle::grader {

/// One student of a class.
struct ClassRow {
  std::string student;                 ///< printable
  std::optional<std::string> trouble;  ///< why the hand-in could not be read: no points, and this note
  GradedSubmission graded;             ///< empty when there is trouble
  std::string report;                  ///< the report's path below the class's folder, with "/"; "" when there is none
  std::string reportFault{};           ///< why there is none of a hand-in that was graded; "" when there is

  /// Points of the whole; nullopt when there is trouble or a fault of the grader.
  std::optional<double> points() const;
  /// The exercise of that topic; nullptr when there is trouble or the course has none.
  const GradedExercise* exercise(const std::string& topic) const;
  /// Why there are no points, on one printable line; "" when there are.
  std::string whyNoPoints() const;
};

/// A graded class, in the order of its students.
struct GradedClass {
  std::string name;
  std::vector<Manifest> course;  ///< the exercises that were graded
  std::vector<ClassRow> rows;
  std::vector<std::string> notes;  ///< children of the folder that are no submissions; untrusted text inside
  std::string sandbox;
  std::vector<UnnamedGroup> unnamed{};  ///< ClassOptions::unnamed: the largest first
  std::string outFault{};               ///< why grades.csv or class.html could not be written; "" when they were

  /// Rows without points.
  int faults() const;
  bool hasFault() const { return faults() > 0; }
  /// "STUDENT: why", a line for each report that could not be written.
  std::vector<std::string> missingReports() const;
  double maxPoints() const;
};

/// Sum of the criteria's points.
double maxPoints(const Manifest& exercise);

/// Points of one exercise; nullopt when a criterion has none.
std::optional<double> pointsOf(const GradedExercise& exercise);

}  // namespace muelle::grader
