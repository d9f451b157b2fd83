#include "grader/record.h"

#include "base/file.h"
#include "course/testing/mismatch_text.h"
#include "grader/evidence_json.h"

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace muelle::grader {

namespace {

using nlohmann::json;

/// Student output may hold any bytes; JSON wants UTF-8.
std::string dump(const json& document) { return document.dump(1, ' ', false, json::error_handler_t::replace); }

/// Raised whenever the meaning of a field changes: an old record is then as if absent.
constexpr int version = 9;

json toJson(const Mismatch& m) {
  return {{"label", m.label},
          {"expression", m.expression},
          {"of_call", m.ofCall},
          {"call", m.call},
          {"row", m.row},
          {"col", m.col},
          {"rows", m.rows},
          {"cols", m.cols},
          {"got_rows", m.gotRows},
          {"got_cols", m.gotCols},
          // As text: JSON knows no number that is not finite.
          {"got", exactText(m.got)},
          {"expected", exactText(m.expected)},
          {"tolerance", exactText(m.tolerance)},
          {"unit", m.unit},
          {"says", m.says}};
}

/// Throws json::exception or std::bad_optional_access.
double number(const json& document, const char* name) {
  return exactNumber(document.at(name).get<std::string>()).value();
}

Mismatch mismatchFromJson(const json& document) {
  Mismatch m;
  document.at("label").get_to(m.label);
  document.at("expression").get_to(m.expression);
  document.at("of_call").get_to(m.ofCall);
  document.at("call").get_to(m.call);
  document.at("row").get_to(m.row);
  document.at("col").get_to(m.col);
  document.at("rows").get_to(m.rows);
  document.at("cols").get_to(m.cols);
  document.at("got_rows").get_to(m.gotRows);
  document.at("got_cols").get_to(m.gotCols);
  m.got = number(document, "got");
  m.expected = number(document, "expected");
  m.tolerance = number(document, "tolerance");
  document.at("unit").get_to(m.unit);
  document.at("says").get_to(m.says);
  return m;
}

json toJson(const TestOutcome& test) {
  json mismatches = json::array();
  for (const Mismatch& mismatch : test.mismatches) mismatches.push_back(toJson(mismatch));
  return {{"name", test.name},        {"property", test.property}, {"passed", test.passed},
          {"mismatches", mismatches}, {"call", test.call},         {"seen", {test.seen.function, test.seen.id}}};
}

TestOutcome testFromJson(const json& document) {
  TestOutcome test;
  document.at("name").get_to(test.name);
  document.at("property").get_to(test.property);
  document.at("passed").get_to(test.passed);
  for (const json& each : document.at("mismatches")) test.mismatches.push_back(mismatchFromJson(each));
  document.at("call").get_to(test.call);
  test.seen = {document.at("seen").at(0), document.at("seen").at(1)};
  return test;
}

json toJson(const std::vector<double>& numbers) {
  json list = json::array();
  for (const double number : numbers) list.push_back(exactText(number));
  return list;
}

std::vector<double> numbersFrom(const json& list) {
  std::vector<double> numbers;
  for (const json& each : list) numbers.push_back(exactNumber(each.get<std::string>()).value());
  return numbers;
}

json toJson(const CounterExample& example) {
  return {{"function", example.function},
          {"arguments", example.arguments},
          {"got", toJson(example.got)},
          {"expected", toJson(example.expected)},
          {"is_verdict", example.isVerdict}};
}

CounterExample exampleFromJson(const json& document) {
  return {document.at("function"), document.at("arguments"), numbersFrom(document.at("got")),
          numbersFrom(document.at("expected")), document.at("is_verdict").get<bool>()};
}

/// Throws json::exception; std::runtime_error or std::bad_optional_access for values that are none of ours.
Verdict verdictFromJson(const json& document) {
  if (document.at("version").get<int>() != version) throw std::runtime_error("a record of another version");
  Verdict verdict;
  document.at("topic").get_to(verdict.topic);
  document.at("suite").get_to(verdict.suite);
  const std::string outcome = document.at("outcome");
  document.at("timed_out").get_to(verdict.timedOut);
  document.at("never_written").get_to(verdict.neverWritten);
  verdict.outcome = outcomeNamed(outcome);
  if (nameOf(verdict.outcome) != outcome) throw std::runtime_error("a record of an unknown outcome");
  for (const json& test : document.at("tests")) verdict.tests.push_back(testFromJson(test));
  verdict.evidence = evidenceFromJson(document.at("evidence"));
  for (const json& each : document.at("examples")) verdict.examples.push_back(exampleFromJson(each));
  document.at("fault").get_to(verdict.fault);
  document.at("confirmed").get_to(verdict.isConfirmed);
  document.at("grader_fault").get_to(verdict.graderFault);
  document.at("output").get_to(verdict.output);
  document.at("followed").get_to(verdict.followed);
  document.at("seconds").get_to(verdict.seconds);
  document.at("calls").get_to(verdict.calls);
  return verdict;
}

}  // namespace

bool Verdict::passed() const {
  return outcome == Outcome::Passed && fault.empty() && graderFault.empty() && !tests.empty() &&
         std::all_of(tests.begin(), tests.end(), [](const TestOutcome& test) { return test.passed; });
}

void writeRecord(const Verdict& verdict, const std::filesystem::path& file) {
  json tests = json::array();
  for (const TestOutcome& test : verdict.tests) tests.push_back(toJson(test));
  json examples = json::array();
  for (const CounterExample& example : verdict.examples) examples.push_back(toJson(example));
  writeFile(file, dump({{"version", version},
                        {"topic", verdict.topic},
                        {"suite", verdict.suite},
                        {"outcome", nameOf(verdict.outcome)},
                        {"tests", tests},
                        {"evidence", toJson(verdict.evidence)},
                        {"examples", examples},
                        {"fault", verdict.fault},
                        {"confirmed", verdict.isConfirmed},
                        {"grader_fault", verdict.graderFault},
                        {"timed_out", verdict.timedOut},
                        {"never_written", verdict.neverWritten},
                        {"output", verdict.output},
                        {"followed", verdict.followed},
                        {"seconds", verdict.seconds},
                        {"calls", verdict.calls}}));
}

std::optional<Verdict> readRecord(const std::filesystem::path& file) {
  std::ifstream stream(file);
  if (!stream) return std::nullopt;
  try {
    return verdictFromJson(json::parse(stream));
  } catch (const std::exception&) {
    return std::nullopt;
  }
}

}  // namespace muelle::grader
