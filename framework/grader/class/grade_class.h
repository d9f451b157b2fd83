#pragma once
#include "grader/class/class_table.h"
#include "grader/run/grade.h"

#include <functional>

namespace muelle::grader {

/// Which class is graded, and where its reports go.
struct ClassOptions {
  std::filesystem::path folder;  ///< each child is one submission
  std::filesystem::path out;     ///< grades.csv, class.html, reports/STUDENT/
  int jobs = 1;
  bool unnamed = false;  ///< also group the hand-ins without a name by their answers
};

/// Grades every submission of a folder through one pool and writes grades.csv, the page of the class and each report.
/// A hand-in that cannot be read is a row without points and with a note; the others are graded. What has been graded
/// before (an earlier run that was killed, say) is found again by its content and not graded twice.
/// \param progress called with the part of the submissions that are done
/// What cannot be written is told in the class, whose points are right all the same.
/// Throws std::runtime_error when the folder cannot be read or holds no submission.
GradedClass gradeClass(Grader& grader, const ClassOptions& options,
                       const std::function<void(double fraction)>& progress = {});

}  // namespace muelle::grader
