#include "grader/evidence_json.h"

#include "course/testing/mismatch_text.h"

#include <nlohmann/json.hpp>

namespace muelle::grader {

namespace {

using nlohmann::json;

/// JSON knows no number that is not finite.
json exact(double number) { return exactText(number); }
double exactOf(const json& document) { return exactNumber(document.get<std::string>()).value(); }

json toJson(const std::vector<Leaf>& leaves) {
  json list = json::array();
  for (const Leaf& leaf : leaves) list.push_back({leaf.argument, leaf.field, leaf.component});
  return list;
}

std::vector<Leaf> leavesFrom(const json& list) {
  std::vector<Leaf> leaves;
  for (const json& each : list) leaves.push_back({each.at(0), each.at(1), each.at(2)});
  return leaves;
}

json toJson(const WrongAnswer& answer) {
  json numbers = json::array();
  for (const double number : answer.numbers) numbers.push_back(exact(number));
  return {answer.question, exact(answer.roundOff), numbers};
}

WrongAnswer wrongAnswerFrom(const json& document) {
  WrongAnswer answer{document.at(0), {}, exactOf(document.at(1))};
  for (const json& number : document.at(2)) answer.numbers.push_back(exactOf(number));
  return answer;
}

json toJson(const FunctionEvidence& evidence) {
  json agreeing = json::array();
  for (const Hypothesis& each : evidence.agreeing) {
    agreeing.push_back({each.id, each.isListed, toJson(each.of), exact(each.value), each.isExact});
  }
  json features = json::array();
  for (const auto& [feature, range] : evidence.features) {
    features.push_back({feature.kind, toJson(feature.of), exact(range.fewestRight), exact(range.mostRight),
                        exact(range.fewestWrong), exact(range.mostWrong), exact(range.fewestPlain),
                        exact(range.mostPlain)});
  }
  json answers = json::array();
  for (const WrongAnswer& each : evidence.answers) answers.push_back(toJson(each));
  json listed = json::array();
  for (const ListedMistake& each : evidence.listed) listed.push_back({each.id, each.group});
  return {{"calls", evidence.calls},
          {"wrong", evidence.wrong},
          {"imprecise", evidence.imprecise},
          {"worst_near", exact(evidence.worstNear)},
          {"unwritten", evidence.isUnwritten},
          {"not_a_number", evidence.notANumber},
          {"zero", evidence.zero},
          {"wrong_zero", evidence.wrongZero},
          {"plain_right", evidence.plainRight},
          {"stateful", evidence.isStateful},
          {"constant", evidence.isConstant},
          {"agreeing", agreeing},
          {"features", features},
          {"answers", answers},
          {"listed", listed}};
}

FunctionEvidence functionFrom(const json& document) {
  FunctionEvidence evidence;
  document.at("calls").get_to(evidence.calls);
  document.at("wrong").get_to(evidence.wrong);
  document.at("imprecise").get_to(evidence.imprecise);
  evidence.worstNear = exactOf(document.at("worst_near"));
  document.at("unwritten").get_to(evidence.isUnwritten);
  document.at("not_a_number").get_to(evidence.notANumber);
  document.at("zero").get_to(evidence.zero);
  document.at("wrong_zero").get_to(evidence.wrongZero);
  document.at("plain_right").get_to(evidence.plainRight);
  document.at("stateful").get_to(evidence.isStateful);
  document.at("constant").get_to(evidence.isConstant);
  for (const json& each : document.at("agreeing")) {
    evidence.agreeing.push_back({each.at(0), each.at(1), leavesFrom(each.at(2)), exactOf(each.at(3)), each.at(4)});
  }
  for (const json& each : document.at("features")) {
    evidence.features[{each.at(0), leavesFrom(each.at(1))}] = {exactOf(each.at(2)), exactOf(each.at(3)),
                                                               exactOf(each.at(4)), exactOf(each.at(5)),
                                                               exactOf(each.at(6)), exactOf(each.at(7))};
  }
  for (const json& each : document.at("answers")) evidence.answers.push_back(wrongAnswerFrom(each));
  for (const json& each : document.at("listed")) evidence.listed.push_back({each.at(0), each.at(1)});
  return evidence;
}

}  // namespace

json toJson(const Evidence& evidence) {
  json document = json::object();
  for (const auto& [function, each] : evidence) document[function] = toJson(each);
  return document;
}

Evidence evidenceFromJson(const json& document) {
  Evidence evidence;
  for (const auto& [function, each] : document.items()) evidence.emplace(function, functionFrom(each));
  return evidence;
}

}  // namespace muelle::grader
