#include "grader/authors/grade_again.h"

#include "grader/run/grade.h"

namespace muelle::grader {

std::vector<UnnamedGroup> gradeAgain(const Workplace& workplace, const GradeOptions& options,
                                     const std::vector<UnnamedHandIn>& handIns, int jobs) {
  GradeOptions again = options;
  again.forAuthors = true;
  again.withCurves = false;
  Grader grader(workplace, {}, again, makeSandbox(again.sandbox));
  Pool pool(jobs);
  std::vector<std::vector<UnnamedMistake>> found(handIns.size());
  for (std::size_t i = 0; i < handIns.size(); ++i) {
    grader.addExercise(pool, handIns[i].manifest, &handIns[i].sources, {},
                       [&found, i](const GradedExercise& graded) { found[i] = unnamedMistakes(graded); });
  }
  pool.run();
  std::vector<UnnamedGroup> single;
  for (std::size_t i = 0; i < handIns.size(); ++i) {
    const UnnamedHandIn& handIn = handIns[i];
    for (UnnamedMistake& mistake : found[i]) {
      single.push_back(
          {handIn.manifest.topic, {handIn.name}, std::move(mistake), handIn.sources.at(handIn.manifest.files.front())});
    }
  }
  return joinAlike(std::move(single));
}

}  // namespace muelle::grader
