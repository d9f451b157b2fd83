#pragma once
#include "grader/class/graded_class.h"

#include <string>

namespace muelle::grader {

/// A line a student: points of each exercise and of all; below, the medians, what was hardest and commonest, and why
/// some have no points. `colour` only on a terminal; no line is wider than `width` columns (from 40 on).
std::string classTable(const GradedClass& graded, bool colour, int width);

/// student,exercise,criterion,points,max,mistake,note: a line for each criterion of each student, in the order of the
/// class, the course and the manifest. Points are empty where there is no score (a hand-in that cannot be read, a fault
/// of the grader), and the note says why. No times: the same class gives the same bytes.
std::string gradesCsv(const GradedClass& graded);

/// One self-contained page: histogram of the points, hardest criteria, commonest mistakes, a link to each report. No
/// script, no outside resource; every text of a submission escaped.
std::string classPage(const GradedClass& graded);

}  // namespace muelle::grader
