#include "grader/report/followed.h"
#include "grader/report/format.h"
#include "grader/report/report.h"

#include <fmt/format.h>
#include <pugixml.hpp>
#include <sstream>

namespace muelle::grader {

namespace {

struct Counts {
  std::size_t tests = 0, failures = 0, errors = 0;
};

double secondsOf(const Criterion& criterion, const GradedExercise& exercise) {
  const auto found = exercise.verdicts.find(criterion.suite);
  return found == exercise.verdicts.end() ? 0.0 : found->second.seconds;
}

/// An attribute of untrusted text.
void setText(pugi::xml_node node, const char* name, const std::string& text) {
  node.append_attribute(name) = fieldLine(text).c_str();
}

void setSeconds(pugi::xml_node node, double seconds) {
  node.append_attribute("time") = fmt::format("{:.3f}", seconds).c_str();
}

void setCounts(pugi::xml_node node, const Counts& counts) {
  node.append_attribute("tests") = static_cast<unsigned long long>(counts.tests);
  node.append_attribute("failures") = static_cast<unsigned long long>(counts.failures);
  node.append_attribute("errors") = static_cast<unsigned long long>(counts.errors);
  node.append_attribute("skipped") = 0;
}

/// An element that holds untrusted text of several lines.
pugi::xml_node appendText(pugi::xml_node parent, const char* name, const std::string& text) {
  pugi::xml_node node = parent.append_child(name);
  node.text() = field(text).c_str();
  return node;
}

void appendOutcome(pugi::xml_node test, const Criterion& criterion, const GradedExercise& exercise, Counts& counts) {
  const Explanation::State state = explain(criterion, exercise).state;
  ++counts.tests;
  if (state == Explanation::State::Passed) return;
  const bool ours = state == Explanation::State::GraderFault;
  ++(ours ? counts.errors : counts.failures);
  const std::vector<std::string> lines = feedback(criterion, exercise);
  pugi::xml_node outcome = appendText(test, ours ? "error" : "failure", feedbackText(criterion, exercise));
  setText(outcome, "message", lines.empty() ? "" : lines.front());
  setText(outcome, "type", showState(state));
}

void appendCase(pugi::xml_node suite, const Criterion& criterion, const GradedExercise& exercise, Counts& counts) {
  pugi::xml_node test = suite.append_child("testcase");
  setText(test, "classname", exercise.manifest.topic);
  setText(test, "name", criterion.suite);
  setSeconds(test, secondsOf(criterion, exercise));
  appendOutcome(test, criterion, exercise, counts);
  const std::string printed = shownOutput(criterion, exercise);
  if (!printed.empty()) appendText(test, "system-out", printed);
}

/// How the file was taken and what was earned in spite of a lower function concern the passed criteria, too, which have
/// no words of their own.
void appendNotes(pugi::xml_node suite, const GradedExercise& exercise) {
  std::vector<std::string> notes = followedSentences(exercise);
  if (!exercise.note.empty()) notes.insert(notes.begin(), exercise.note);
  if (exercise.seed != 0) notes.push_back(seedSentence(exercise));
  if (notes.empty()) return;
  pugi::xml_node properties = suite.append_child("properties");
  for (const std::string& note : notes) {
    pugi::xml_node property = properties.append_child("property");
    property.append_attribute("name") = "note";
    setText(property, "value", note);
  }
}

void appendSuite(pugi::xml_node suites, const GradedExercise& exercise, const std::string& date, Counts& total) {
  pugi::xml_node suite = suites.append_child("testsuite");
  setText(suite, "name", exercise.manifest.topic);
  appendNotes(suite, exercise);
  Counts counts;
  double seconds = 0.0;
  for (const Criterion& criterion : exercise.manifest.criteria) {
    appendCase(suite, criterion, exercise, counts);
    seconds += secondsOf(criterion, exercise);
  }
  setCounts(suite, counts);
  setSeconds(suite, seconds);
  setText(suite, "timestamp", date);
  total = {total.tests + counts.tests, total.failures + counts.failures, total.errors + counts.errors};
}

}  // namespace

std::string junitXml(const GradedSubmission& graded) {
  pugi::xml_document document;
  pugi::xml_node declaration = document.append_child(pugi::node_declaration);
  declaration.append_attribute("version") = "1.0";
  declaration.append_attribute("encoding") = "UTF-8";
  pugi::xml_node suites = document.append_child("testsuites");
  setText(suites, "name", graded.name);
  Counts total;
  for (const GradedExercise& exercise : graded.exercises) appendSuite(suites, exercise, graded.date, total);
  setCounts(suites, total);
  setSeconds(suites, graded.seconds);
  std::ostringstream xml;
  document.save(xml, "  ");
  return xml.str();
}

}  // namespace muelle::grader
