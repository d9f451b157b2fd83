#include "staged.h"

#include "grader/matrix/expectation.h"

#include <set>

namespace muelle::grader {

namespace fs = std::filesystem;

namespace {

Sources sourcesIn(const fs::path& folder, const Manifest& exercise) {
  Sources sources;
  for (const std::string& file : exercise.files) sources[file] = readFile(folder / file);
  return sources;
}

fs::path firstIn(const fs::path& folder) {
  std::set<fs::path> children;
  for (const auto& entry : fs::directory_iterator(folder)) children.insert(entry.path());
  return *children.begin();
}

/// Of an exercise the criteria that the wrong submission loses and the first two that it passes: a fault strikes
/// three or four as it strikes ten, and a grading is over in a third of the time.
std::vector<Criterion> someCriteria(const Manifest& exercise, const Sources& wrong) {
  const std::set<std::string> lost = readExpectation(wrong.begin()->second, "the wrong one", exercise).lost;
  std::vector<Criterion> some;
  int passed = 0;
  for (const Criterion& criterion : exercise.criteria) {
    if (lost.contains(criterion.suite) || ++passed <= 2) some.push_back(criterion);
  }
  return some;
}

}  // namespace

StagedFault::StagedFault() : whole_(readCourse(workplace_.exercises()).front()), exercise_(whole_) {
  workplace_.kept = folder_.path() / "kept";
  honest_ = sourcesIn(workplace_.source / "solutions" / exercise_.topic, exercise_);
  const fs::path corpus = workplace_.source / "tests" / "submissions" / exercise_.topic;
  wrong_ = sourcesIn(firstIn(corpus / "wrong"), exercise_);
  exercise_.criteria = someCriteria(whole_, wrong_);
}

GradedExercise StagedFault::grade(const Sources& sources, SandboxChoice sandbox, bool withCurves) {
  return grade(sources, makeSandbox(sandbox), sandbox, withCurves);
}

GradedExercise StagedFault::grade(const Sources& sources, int jobs) {
  constexpr SandboxChoice any = SandboxChoice::Automatic;
  return grade(sources, makeSandbox(any), any, false, jobs);
}

GradedExercise StagedFault::grade(const Sources& sources, std::unique_ptr<Sandbox> sandbox, SandboxChoice choice,
                                  bool withCurves, int jobs) {
  GradeOptions options;
  options.seed = "staged faults";
  options.sandbox = choice;
  options.withCurves = withCurves;
  Grader grader(workplace_, {exercise_}, options, std::move(sandbox));
  Pool pool(jobs);
  GradedExercise result;
  grader.addExercise(pool, exercise_, &sources, {}, [&result](GradedExercise graded) { result = std::move(graded); });
  pool.run();
  started_ = grader.started();
  return result;
}

void StagedFault::expectNoScore(const GradedExercise& graded) {
  EXPECT_TRUE(hasGraderFault(graded));
  double sum = 0.0;
  for (const Criterion& criterion : graded.manifest.criteria) sum += score(criterion, graded).value_or(0.0);
  const bool wasBuilt = graded.build.status == BuildOutcome::Status::Built;
  const bool isOurs = graded.build.status == BuildOutcome::Status::GraderFault;
  EXPECT_TRUE(wasBuilt || isOurs) << "the student is blamed: " << graded.build.message;
  if (isOurs) {
    EXPECT_EQ(sum, 0.0);
  }
  // What a criterion got before the fault is right; what it did not get has no score instead of none.
  for (const auto& [suite, verdict] : graded.verdicts) {
    const auto criterion = std::find_if(graded.manifest.criteria.begin(), graded.manifest.criteria.end(),
                                        [&](const Criterion& c) { return c.suite == suite; });
    ASSERT_NE(criterion, graded.manifest.criteria.end());
    const auto points = score(*criterion, graded);
    if (points) {
      EXPECT_TRUE(*points == criterion->points || !verdict.passed());
    }
  }
}

std::map<std::string, double> StagedFault::calmPoints(const Sources& sources) const {
  static std::map<std::pair<Sources, std::size_t>, std::map<std::string, double>> known;
  auto& points = known[{sources, exercise_.criteria.size()}];
  if (points.empty()) {
    // Kept for all tests of this build, each of which is a process: it is the same for every one of them, and what is
    // kept is found by all that decides it.
    Workplace workplace = Workplace::ofThisBuild();
    workplace.kept = workplace.binary / "calm";
    GradeOptions options;
    options.seed = "staged faults";
    options.withCurves = false;
    Grader grader(workplace, {exercise_}, options, makeSandbox(SandboxChoice::Automatic));
    Pool pool(2);
    grader.addExercise(pool, exercise_, &sources, {}, [&](const GradedExercise& calm) {
      for (const Criterion& criterion : calm.manifest.criteria) {
        points[criterion.suite] = score(criterion, calm).value_or(-1.0);
      }
    });
    pool.run();
  }
  return points;
}

void StagedFault::expectNothingWrong(const GradedExercise& graded, const Sources& sources) const {
  const auto calm = calmPoints(sources);
  if (graded.build.status == BuildOutcome::Status::GraderFault) return;
  EXPECT_EQ(graded.build.status, BuildOutcome::Status::Built) << graded.build.message << graded.build.diagnostics;
  for (const Criterion& criterion : graded.manifest.criteria) {
    const auto points = score(criterion, graded);
    if (points) {
      EXPECT_EQ(*points, calm.at(criterion.suite)) << criterion.suite;
    }
  }
}

void StagedFault::expectUndisturbed(const GradedExercise& graded, const Sources& sources) const {
  const auto calm = calmPoints(sources);
  EXPECT_EQ(graded.build.status, BuildOutcome::Status::Built) << graded.build.message << graded.build.diagnostics;
  for (const Criterion& criterion : graded.manifest.criteria) {
    const auto verdict = graded.verdicts.find(criterion.suite);
    const std::string said = verdict == graded.verdicts.end() ? "" : verdict->second.fault;
    EXPECT_EQ(score(criterion, graded), calm.at(criterion.suite)) << criterion.suite << ": " << said;
    if (sources == honest_) {
      EXPECT_EQ(score(criterion, graded), criterion.points) << criterion.suite;
    }
  }
}

void StagedFault::putInCompilersPlace(const std::string& script) {
  const fs::path file = folder_.path() / "compiler";
  const std::string real = Workplace::ofThisBuild().compiler.string();
  writeFile(file, "#!/bin/sh\ncompiler=" + real + "\n" + script + "\n");
  fs::permissions(file, fs::perms::owner_all | fs::perms::group_read | fs::perms::group_exec | fs::perms::others_read |
                            fs::perms::others_exec);
  workplace_.compiler = file;
}

void StagedFault::putCompilerBack() { workplace_.compiler = Workplace::ofThisBuild().compiler; }

}  // namespace muelle::grader
