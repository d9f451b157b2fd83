#pragma once
#include "grader/verdict.h"

#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace muelle::grader {

/// Every sentence that a student reads about an exercise, with # in place of each number, so that one sentence about
/// many inputs is one. What the compiler says of a source is not among them.
std::set<std::string> sentencesOf(const GradedExercise& exercise);

/// The sentences of a golden file; none where there is no such file.
std::set<std::string> readSentences(const std::filesystem::path& file);

/// Writes the golden file of an exercise: a sentence a line, sorted, for a person to read through.
void writeSentences(const std::filesystem::path& file, const std::set<std::string>& sentences);

/// Where the sentences are others than the golden file's, a line each: those that it does not hold, and, when
/// `isComplete`, those that nobody was told. None when there is no such file.
std::vector<std::string> differencesOfSentences(const std::filesystem::path& file,
                                                const std::set<std::string>& sentences, bool isComplete);

}  // namespace muelle::grader
