#include "lab/hard_cases/references.h"

#include "base/file.h"

#include <fmt/format.h>
#include <cstdlib>
#include <map>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace muelle::hard_cases {

namespace {

struct Collection {
  std::vector<CaseFacts> cases;
  std::map<std::string, std::map<std::string, std::string>> values;
};

const Collection& collection() {
  static const Collection all = [] {
    Collection read;
    const nlohmann::json file = nlohmann::json::parse(readFile(MUELLE_HARD_CASES));
    for (const nlohmann::json& entry : file.at("cases")) {
      CaseFacts facts{entry.at("id"), entry.at("name"), entry.at("correct"), entry.at("how")};
      for (const auto& [name, value] : entry.at("reference").items()) read.values[facts.id][name] = value.at("value");
      read.cases.push_back(std::move(facts));
    }
    return read;
  }();
  return all;
}

const std::map<std::string, std::string>& valuesOf(const std::string& id) {
  const auto found = collection().values.find(id);
  if (found == collection().values.end()) throw std::out_of_range(fmt::format("no hard case {}", id));
  return found->second;
}

}  // namespace

const std::vector<CaseFacts>& allCases() { return collection().cases; }

const std::string& referenceText(const std::string& id, const std::string& name) {
  const auto& values = valuesOf(id);
  const auto found = values.find(name);
  if (found == values.end()) throw std::out_of_range(fmt::format("hard case {} has no reference '{}'", id, name));
  return found->second;
}

double reference(const std::string& id, const std::string& name) {
  return std::strtod(referenceText(id, name).c_str(), nullptr);
}

std::vector<std::string> referenceNames(const std::string& id) {
  std::vector<std::string> names;
  for (const auto& [name, value] : valuesOf(id)) names.push_back(name);
  return names;
}

}  // namespace muelle::hard_cases
