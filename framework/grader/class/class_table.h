#pragma once
#include "grader/verdict.h"

#include <optional>
#include <string>
#include <vector>

namespace muelle::grader {

/// One student of a class.
struct ClassRow {
  std::string student;               ///< printable
  std::optional<std::string> trouble;  ///< why the hand-in could not be read: no points, and this note
  GradedSubmission graded;           ///< empty when there is trouble
  std::string report;                ///< the report's path below the class's folder; "" when there is none

  /// Points of the whole; nullopt when there is trouble or a fault of the grader.
  std::optional<double> points() const;
};

/// A graded class, in the order of its students.
struct GradedClass {
  std::string name;
  std::vector<Manifest> course;
  std::vector<ClassRow> rows;
  std::vector<std::string> notes;  ///< children of the folder that are no submissions
  std::string sandbox;

  int faults() const;
  bool hasFault() const { return faults() > 0; }
};

/// A line a student: points of each exercise and of all; below, what was commonest.
std::string classTable(const GradedClass& graded, bool colour, int width);

/// student,exercise,criterion,points,max,mistake,note: a line for each criterion. No times: the same class gives the
/// same bytes.
std::string gradesCsv(const GradedClass& graded);

/// One self-contained page: histogram of the points, hardest criteria, commonest mistakes, a link to each report.
std::string classPage(const GradedClass& graded);

}  // namespace muelle::grader
