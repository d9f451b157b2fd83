#include "sample_class.h"

#include "sample.h"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <random>

namespace muelle::grader {

namespace {

std::string nameOf(int number) { return fmt::format("student {:02}", number); }

ClassRow rowOf(int number, GradedExercise exercise) {
  ClassRow row;
  row.student = nameOf(number);
  row.graded.name = row.student;
  row.graded.exercises.push_back(std::move(exercise));
  row.report = fmt::format("reports/{}/report.html", row.student);
  return row;
}

const std::array<std::pair<const char*, const char*>, 6> topics{{{"spring_1d", "A spring on a line"},
                                                                 {"spring_3d", "Springs in space"},
                                                                 {"energy_gradient", "The energy of a spring"},
                                                                 {"triangle", "The elastic force of a triangle"},
                                                                 {"damping", "Three ways to damp a spring"},
                                                                 {"contact", "Contact: obstacles as forces"}}};

Manifest sampleExercise(std::size_t index) {
  Manifest manifest = exerciseWithoutVerdicts().manifest;
  manifest.topic = topics[index].first;
  manifest.title = topics[index].second;
  manifest.files = {manifest.topic + ".cpp"};
  manifest.points = 10;
  manifest.criteria.push_back({"The energy never grows", "Energy", 3, true, "sum over all springs once", {"energy"}});
  return manifest;
}

/// The mistake as a run of the grader leaves it: with its words, where the manifest has some.
NamedMistake named(const std::string& id, const Manifest& manifest) {
  const auto known = std::ranges::find(manifest.misconceptions, id, &Misconception::id);
  if (known == manifest.misconceptions.end()) return {id, "springForce", "", ""};
  return {id, known->function, known->says, known->hint};
}

/// One student's way through the course; later exercises are harder.
class Student {
 public:
  explicit Student(int number) : random_(static_cast<std::uint32_t>(number) * 2654435761U) {
    skill_ = 0.55 + 0.45 * part();
  }

  GradedExercise exercise(std::size_t index) {
    GradedExercise exercise;
    exercise.manifest = sampleExercise(index);
    const double chance = skill_ - 0.06 * static_cast<double>(index);
    if (part() > chance + 0.45) {
      exercise.build = {BuildOutcome::Status::Missing, exercise.manifest.topic + ".cpp was not handed in", ""};
      return exercise;
    }
    exercise.build.status = BuildOutcome::Status::Built;
    for (const Criterion& criterion : exercise.manifest.criteria) judge(exercise, criterion, chance);
    return exercise;
  }

 private:
  double part() { return static_cast<double>(random_()) / static_cast<double>(std::minstd_rand::max()); }

  void judge(GradedExercise& exercise, const Criterion& criterion, double chance) {
    const int passed = part() < chance + 0.1 ? 4 : static_cast<int>(4.0 * part());
    Verdict judged = verdict(criterion.suite, passed, 4 - passed);
    judged.topic = exercise.manifest.topic;
    if (criterion.suite == "HookeForce" && passed < 4) judged.mistakes = {named("wrong_sign", exercise.manifest)};
    exercise.verdicts[criterion.suite] = judged;
  }

  std::minstd_rand random_;
  double skill_;
};

}  // namespace

ClassRow student(int number, Tests hooke, Tests acceleration) {
  return rowOf(number, with(with(exerciseWithoutVerdicts(), verdict("HookeForce", hooke.passed, hooke.failed)),
                            verdict("Acceleration", acceleration.passed, acceleration.failed)));
}

ClassRow studentWithoutFile(int number) {
  GradedExercise exercise = exerciseWithoutVerdicts();
  exercise.build = {BuildOutcome::Status::Missing, "spring_1d.cpp was not handed in", ""};
  return rowOf(number, std::move(exercise));
}

ClassRow unreadable(int number, const std::string& trouble) {
  ClassRow row;
  row.student = nameOf(number);
  row.trouble = trouble;
  return row;
}

GradedClass classOfOneExercise(std::vector<ClassRow> rows) {
  GradedClass graded;
  graded.name = "mechanics";
  graded.course = {exerciseWithoutVerdicts().manifest};
  graded.rows = std::move(rows);
  graded.sandbox = "bubblewrap";
  return graded;
}

ClassRow withMistake(ClassRow row, const std::string& id) {
  GradedExercise& exercise = row.graded.exercises[0];
  exercise.verdicts.at("HookeForce").mistakes.push_back(named(id, exercise.manifest));
  return row;
}

ClassRow withFault(ClassRow row, const std::string& fault) {
  row.graded.exercises[0].verdicts.at("Acceleration").graderFault = fault;
  return row;
}

GradedClass sampleClass(int students) {
  GradedClass graded = classOfOneExercise({});
  graded.course.clear();
  for (std::size_t i = 0; i < topics.size(); ++i) graded.course.push_back(sampleExercise(i));
  for (int number = 1; number <= students; ++number) {
    ClassRow row = rowOf(number, {});
    row.graded.exercises.clear();
    Student one(number);
    for (std::size_t i = 0; i < topics.size(); ++i) row.graded.exercises.push_back(one.exercise(i));
    graded.rows.push_back(std::move(row));
  }
  if (students > 20) {
    graded.rows[6] = unreadable(7, "hand-in.zip is broken: its checksum is wrong; ask for it again");
    graded.rows[19].graded.exercises[2].verdicts["Energy"].graderFault = "no space left on the disk";
  }
  graded.notes = {"grades.xlsx is a file and no archive"};
  return graded;
}

GradedClass hostileClass(const std::string& text) {
  ClassRow row;
  row.student = text;
  row.graded = hostileSubmission(text);
  row.graded.exercises.pop_back();
  row.report = text;
  ClassRow wrong = row;
  wrong.graded.exercises[0].verdicts.at("Acceleration").graderFault.clear();
  ClassRow broken = unreadable(2, text);
  broken.student = text;
  ClassRow refused = row;
  refused.graded.exercises[0] = hostileSubmission(text).exercises[1];
  GradedClass graded = classOfOneExercise({row, wrong, broken, refused});
  graded.name = text;
  graded.notes = {text};
  graded.sandbox = text;
  return graded;
}

}  // namespace muelle::grader
