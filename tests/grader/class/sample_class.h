#pragma once
#include "grader/class/graded_class.h"

#include <string>

namespace muelle::grader {

/// A student "student 07" with the exercise of sample.h, in which as many tests of HookeForce (4 points, all or
/// nothing) and of Acceleration (3 points, in proportion) passed and failed.
struct Tests {
  int passed = 1;
  int failed = 0;
};
ClassRow student(int number, Tests hooke, Tests acceleration);

/// A student who did not hand the exercise in.
ClassRow studentWithoutFile(int number);

/// A student whose hand-in cannot be read.
ClassRow unreadable(int number, const std::string& trouble);

/// The class of these students, with the exercise of sample.h as its course.
GradedClass classOfOneExercise(std::vector<ClassRow> rows);

/// Named in the criterion HookeForce, whose tests failed.
ClassRow withMistake(ClassRow row, const std::string& id);

/// The criterion Acceleration met a fault of the grader.
ClassRow withFault(ClassRow row, const std::string& fault);

/// A class like a real one: six exercises, all states, the same numbers each time.
GradedClass sampleClass(int students);

/// A class with the text in every place that a submission can reach.
GradedClass hostileClass(const std::string& text);

}  // namespace muelle::grader
