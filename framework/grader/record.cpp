#include "grader/record.h"

#include "base/file.h"

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

namespace muelle::grader {

namespace {

using nlohmann::json;

/// Student output may hold any bytes; JSON wants UTF-8.
std::string dump(const json& document) { return document.dump(1, ' ', false, json::error_handler_t::replace); }

json toJson(const TestOutcome& test) {
  return {{"name", test.name},
          {"property", test.property},
          {"passed", test.passed},
          {"details", test.details},
          {"call", test.call}};
}

TestOutcome testFromJson(const json& document) {
  TestOutcome test;
  document.at("name").get_to(test.name);
  document.at("property").get_to(test.property);
  document.at("passed").get_to(test.passed);
  document.at("details").get_to(test.details);
  document.at("call").get_to(test.call);
  return test;
}

}  // namespace

bool Verdict::passed() const {
  return fault.empty() && graderFault.empty() && !tests.empty() &&
         std::all_of(tests.begin(), tests.end(), [](const TestOutcome& test) { return test.passed; });
}

void writeRecord(const Verdict& verdict, const std::filesystem::path& file) {
  json tests = json::array();
  for (const TestOutcome& test : verdict.tests) tests.push_back(toJson(test));
  json mistakes = json::array();
  for (const NamedMistake& mistake : verdict.misconceptions) {
    mistakes.push_back({{"id", mistake.id}, {"function", mistake.function}});
  }
  writeFile(file, dump({{"topic", verdict.topic},
                        {"suite", verdict.suite},
                        {"tests", tests},
                        {"misconceptions", mistakes},
                        {"fault", verdict.fault},
                        {"grader_fault", verdict.graderFault},
                        {"output", verdict.output},
                        {"seconds", verdict.seconds},
                        {"calls", verdict.calls}}));
}

std::optional<Verdict> readRecord(const std::filesystem::path& file) {
  std::ifstream stream(file);
  if (!stream) return std::nullopt;
  try {
    const json document = json::parse(stream);
    Verdict verdict;
    document.at("topic").get_to(verdict.topic);
    document.at("suite").get_to(verdict.suite);
    for (const json& test : document.at("tests")) verdict.tests.push_back(testFromJson(test));
    for (const json& mistake : document.at("misconceptions")) {
      verdict.misconceptions.push_back({mistake.at("id"), mistake.at("function")});
    }
    document.at("fault").get_to(verdict.fault);
    document.at("grader_fault").get_to(verdict.graderFault);
    document.at("output").get_to(verdict.output);
    document.at("seconds").get_to(verdict.seconds);
    document.at("calls").get_to(verdict.calls);
    return verdict;
  } catch (const json::exception&) {
    return std::nullopt;
  }
}

}  // namespace muelle::grader
