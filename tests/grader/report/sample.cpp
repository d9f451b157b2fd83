#include "sample.h"

#include <fmt/format.h>

namespace muelle::grader {

GradedExercise exerciseWithoutVerdicts() {
  GradedExercise exercise;
  exercise.manifest.topic = "spring_1d";
  exercise.manifest.title = "A spring in one dimension";
  exercise.manifest.points = 7;
  exercise.manifest.files = {"spring_1d.cpp"};
  exercise.manifest.criteria = {{"Hooke's force on both nodes",
                                 "HookeForce",
                                 4,
                                 false,
                                 "look at the sign of the elongation L - L0",
                                 {"springForce"}},
                                {"Acceleration under gravity",
                                 "Acceleration",
                                 3,
                                 true,
                                 "add all forces before you divide by m",
                                 {"acceleration"}}};
  exercise.manifest.misconceptions = {
      {"wrong_sign", "springForce",
       "Your force has the right size and the wrong sign: F_a points from a towards b when the spring is stretched.",
       "Check which node the unit vector starts at, with xa = 0, xb = 2 and L0 = 1."}};
  exercise.build.status = BuildOutcome::Status::Built;
  return exercise;
}

namespace {

/// The force is off by its sign.
Mismatch forceOff(const std::string& call) {
  Mismatch mismatch;
  mismatch.expression = "springForce(xa, xb, k, L0)";
  mismatch.ofCall = true;
  mismatch.call = call;
  mismatch.got = -2.5;
  mismatch.expected = 2.5;
  mismatch.tolerance = 1e-12;
  return mismatch;
}

}  // namespace

Verdict verdict(const std::string& suite, int passed, int failed) {
  Verdict v;
  v.topic = "spring_1d";
  v.suite = suite;
  v.seconds = 0.25;
  v.outcome = failed == 0 ? Outcome::Passed : Outcome::Wrong;
  for (int i = 0; i < passed; ++i) v.tests.push_back({fmt::format("Holds{}", i), "", true, {}, ""});
  for (int i = 0; i < failed; ++i) {
    v.tests.push_back({fmt::format("Fails{}", i),
                       fmt::format("The force obeys law number {}.", i),
                       false,
                       {forceOff(fmt::format("springForce({}.5, 3.25, 100, 1)", i))},
                       fmt::format("springForce({}.5, 3.25, 100, 1)", i)});
  }
  return v;
}

GradedExercise with(GradedExercise exercise, const Verdict& v) {
  exercise.verdicts[v.suite] = v;
  return exercise;
}

namespace {

GradedExercise renamed(GradedExercise exercise, const std::string& topic, const std::string& title) {
  exercise.manifest.topic = topic;
  exercise.manifest.title = title;
  exercise.manifest.files = {topic + ".cpp"};
  for (auto& [suite, v] : exercise.verdicts) v.topic = topic;
  return exercise;
}

/// A plain drawing in place of gnuplot's.
std::string drawing() {
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 600 360\"><rect width=\"600\" height=\"360\" "
         "fill=\"#fff\"/><path d=\"M60 300V40M60 300H560\" stroke=\"#333\" fill=\"none\"/><path d=\"M60 170C120 20 180 "
         "20 "
         "240 170S360 320 420 170S510 60 560 90\" stroke=\"#999\" stroke-dasharray=\"8 6\" stroke-width=\"3\" "
         "fill=\"none\"/>"
         "<path d=\"M60 170C120 40 190 40 250 180S370 300 430 180S510 90 560 120\" stroke=\"#0072b2\" "
         "stroke-width=\"3\" "
         "fill=\"none\"/><text x=\"270\" y=\"345\" font-size=\"18\" font-family=\"sans-serif\">time [s]</text></svg>";
}

}  // namespace

NamedMistake namedSign() {
  const Misconception stated = exerciseWithoutVerdicts().manifest.misconceptions.front();
  return {stated.id, stated.function, stated.says, stated.hint};
}

GradedSubmission sampleSubmission() {
  Verdict mistaken = verdict("HookeForce", 1, 2);
  mistaken.mistakes = {namedSign()};
  mistaken.output = "L = 2.75\nL = 3.1\n";
  Verdict crashed = verdict("HookeForce", 1, 0);
  crashed.fault = "segmentation fault in springForce";
  crashed.outcome = Outcome::Crash;
  crashed.tests.push_back(
      {"Fails", "A spring of length zero exerts no force.", false, {}, "springForce(1, 1, 100, 1)"});

  GradedExercise right =
      with(with(exerciseWithoutVerdicts(), verdict("HookeForce", 4, 0)), verdict("Acceleration", 3, 0));
  right.figures = {drawing(), drawing()};
  GradedExercise wrong = with(with(exerciseWithoutVerdicts(), mistaken), verdict("Acceleration", 2, 1));
  wrong.figures = {drawing()};
  GradedExercise crash = with(with(exerciseWithoutVerdicts(), crashed), verdict("Acceleration", 0, 1));
  crash.figuresNote = "No curves: the demo stopped with a segmentation fault in springForce.";
  GradedExercise missing = exerciseWithoutVerdicts();
  missing.build = {BuildOutcome::Status::Missing, "damping.cpp was not handed in", ""};
  GradedExercise uncompiled = exerciseWithoutVerdicts();
  uncompiled.build = {
      BuildOutcome::Status::CompileError, "contact.cpp does not compile: 1 error",
      "contact.cpp:14:10: error: 'normal' was not declared in this scope\n   14 |   return normal * k;\n"
      "      |          ^~~~~~"};

  GradedSubmission graded;
  graded.name = "García Núñez, Inés.zip";
  graded.intakeNotes = {"ignored 5 files that the course hands out; its own are used",
                        "ignored in spring_1d/: CMakeLists.txt"};
  graded.exercises = {right, renamed(wrong, "spring_3d", "A spring in three dimensions"),
                      renamed(crash, "energy_gradient", "The force as the negative gradient of the elastic energy"),
                      renamed(missing, "damping", "Damping, three variants"),
                      renamed(uncompiled, "contact", "External contact")};
  graded.sandbox = "bubblewrap";
  graded.date = "2026-03-14T09:26:53Z";
  graded.seconds = 12.3;
  return graded;
}

GradedSubmission hostileSubmission(const std::string& text) {
  Verdict v = verdict("HookeForce", 0, 1);
  v.fault = text;
  v.output = text;
  v.mistakes = {{text, text, text, text}};
  Mismatch said, compared;
  said.says = text;
  compared.label = compared.expression = compared.unit = compared.call = text;
  v.tests[0].mismatches = {said, compared};
  v.tests[0].call = text;
  v.tests[0].property = text;
  Verdict ours = verdict("Acceleration", 1, 0);
  ours.graderFault = text;
  GradedExercise ran = with(with(exerciseWithoutVerdicts(), v), ours);
  ran.figures = {text};
  ran.figuresNote = text;
  ran.note = text;
  GradedExercise unbuilt = exerciseWithoutVerdicts();
  unbuilt.build = {BuildOutcome::Status::CompileError, text, text};
  unbuilt.note = text;
  GradedSubmission graded;
  graded.name = text;
  graded.intakeNotes = {text};
  graded.exercises = {ran, unbuilt};
  graded.sandbox = text;
  return graded;
}

}  // namespace muelle::grader
