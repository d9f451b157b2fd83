#include "course/manifest.h"

#include "base/text/nearest.h"
#include "base/text/printable.h"
#include "base/text/words.h"
#include "base/toml/table.h"

#include <fmt/format.h>
#include <algorithm>
#include <cctype>
#include <cmath>
#include <optional>
#include <set>
#include <stdexcept>
#include <utility>

namespace muelle {

namespace {

bool isLowerName(const std::string& name) {
  const auto isAllowed = [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_'; };
  return !name.empty() && name[0] >= 'a' && name[0] <= 'z' && std::ranges::all_of(name, isAllowed);
}

bool isIdentifier(const std::string& name) {
  const bool beginsWithLetter = !name.empty() && std::isalpha(static_cast<unsigned char>(name[0])) != 0;
  return beginsWithLetter && std::ranges::all_of(name, isNameCharacter);
}

bool isSourceName(const std::string& name) {
  return name.size() > 4 && name.ends_with(".cpp") && isIdentifier(name.substr(0, name.size() - 4));
}

/// A criterion cannot be earned in spite of the function that it judges.
std::vector<std::string> readFollows(const TomlTable& table, const Criterion& criterion) {
  if (!table.has("follows")) return {};
  const std::vector<std::string> follows = table.texts("follows", isIdentifier, "the name of a function");
  for (const std::string& function : follows) {
    if (std::ranges::find(criterion.functions, function) == criterion.functions.end()) continue;
    table.fail("follows", fmt::format("'{}' stands in functions: this criterion judges it", function));
  }
  return follows;
}

Criterion readCriterion(const TomlTable& table) {
  table.checkKeys({"name", "suite", "points", "partial", "functions", "follows", "hint"},
                  {"name", "suite", "points", "functions", "hint"});
  Criterion criterion;
  criterion.name = table.text("name");
  criterion.suite = table.text("suite");
  // GoogleTest forbids underscores in suite names: it makes its own names with them.
  if (!isIdentifier(criterion.suite) || criterion.suite.find('_') != std::string::npos) {
    table.fail("suite",
               fmt::format("'{}' is not the name of a GoogleTest suite (letters and digits)", criterion.suite));
  }
  criterion.points = table.positive("points");
  criterion.partial = table.flag("partial", false);
  criterion.functions = table.texts("functions", isIdentifier, "the name of a function");
  criterion.follows = readFollows(table, criterion);
  criterion.hint = table.text("hint");
  return criterion;
}

Misconception readMisconception(const TomlTable& table) {
  const TomlTable::Keys keys{"id", "function", "says", "hint"};
  table.checkKeys(keys, keys);
  Misconception misconception{table.text("id"), table.text("function"), table.text("says"), table.text("hint")};
  if (!isLowerName(misconception.id)) {
    table.fail("id", fmt::format("'{}' has other characters than a-z, 0-9, _", misconception.id));
  }
  if (!isIdentifier(misconception.function)) {
    table.fail("function", fmt::format("'{}' is not the name of a function", misconception.function));
  }
  return misconception;
}

FeedbackLevel readFeedback(const TomlTable& table) {
  if (!table.has("feedback")) return FeedbackLevel::Values;
  const std::string level = table.choice("feedback", {"criterion", "property", "values"});
  if (level == "criterion") return FeedbackLevel::Criterion;
  return level == "property" ? FeedbackLevel::Property : FeedbackLevel::Values;
}

void readCriteria(const TomlTable& table, Manifest& manifest) {
  std::set<std::string> suites;
  double sum = 0.0;
  for (const TomlTable& one : table.tables("criterion")) {
    const Criterion criterion = readCriterion(one);
    if (!suites.insert(criterion.suite).second) {
      one.fail("suite", fmt::format("'{}' is already that of another criterion", criterion.suite));
    }
    sum += criterion.points;
    manifest.criteria.push_back(criterion);
  }
  if (manifest.criteria.empty()) table.fail("criterion", "at least one [[criterion]] is needed");
  if (std::abs(sum - manifest.points) > 1e-9) {
    table.fail("points", fmt::format("{} is not the sum of the criteria's points, {}", manifest.points, sum));
  }
}

void readMisconceptions(const TomlTable& table, Manifest& manifest) {
  std::set<std::pair<std::string, std::string>> known;
  for (const TomlTable& one : table.tables("misconception")) {
    const Misconception misconception = readMisconception(one);
    if (!known.insert({misconception.id, misconception.function}).second) {
      one.fail("id", fmt::format("'{}' is already that of another misconception of that function", misconception.id));
    }
    manifest.misconceptions.push_back(misconception);
  }
}

Prediction readPrediction(const TomlTable& table) {
  constexpr std::size_t most = 9, longest = 60;
  const TomlTable::Keys keys{"question", "answers"};
  table.checkKeys(keys, keys);
  const auto isShort = [](const std::string& answer) { return !answer.empty() && answer.size() <= longest; };
  Prediction predict{table.text("question"), table.texts("answers", isShort, "an answer of at most 60 characters")};
  if (predict.answers.size() < 2 || predict.answers.size() > most) {
    table.fail("answers", fmt::format("from two to {} answers to choose from are needed", most));
  }
  return predict;
}

Manifest interpret(const TomlTable& table, const std::string& topic) {
  table.checkKeys({"order", "title", "points", "files", "feedback", "call_seconds", "slides", "predict", "criterion",
                   "misconception"},
                  {"order", "title", "points", "files", "criterion"});
  if (!isLowerName(topic)) {
    table.failHere(fmt::format("the folder's name '{}' is the topic: it may have a-z, 0-9 and _ only", topic));
  }
  const auto isAnyText = [](const std::string& value) { return !value.empty(); };
  Manifest manifest;
  manifest.topic = topic;
  manifest.order = table.integer("order", 0, 1'000'000);
  manifest.title = table.text("title");
  manifest.points = table.positive("points");
  manifest.files = table.texts("files", isSourceName, "a plain file name that ends in .cpp");
  manifest.feedback = readFeedback(table);
  manifest.callSeconds = table.integer("call_seconds", usualCallSeconds, longestCallSeconds, usualCallSeconds);
  manifest.slides = table.texts("slides", isAnyText, "the title of a slide");
  readCriteria(table, manifest);
  readMisconceptions(table, manifest);
  if (const std::optional<TomlTable> predict = table.table("predict")) manifest.predict = readPrediction(*predict);
  return manifest;
}

std::vector<std::string> topicsOf(const std::vector<Manifest>& course) {
  std::vector<std::string> topics;
  for (const Manifest& manifest : course) topics.push_back(manifest.topic);
  return topics;
}

}  // namespace

Manifest readManifest(const std::filesystem::path& file) {
  const TomlValue root = readToml(file, shownPath(file));
  return interpret(TomlTable(root, shownPath(file), "the manifest"), file.parent_path().filename().string());
}

std::vector<Manifest> readCourse(const std::filesystem::path& exercises) {
  if (!std::filesystem::is_directory(exercises)) {
    throw std::runtime_error(fmt::format("no folder of exercises at {}", exercises.string()));
  }
  std::vector<Manifest> course;
  for (const auto& entry : std::filesystem::directory_iterator(exercises)) {
    const std::filesystem::path file = entry.path() / "exercise.toml";
    if (std::filesystem::exists(file)) course.push_back(readManifest(file));
  }
  std::ranges::sort(course, {}, [](const Manifest& m) { return std::pair(m.order, m.topic); });
  const auto twins = std::ranges::adjacent_find(course, {}, &Manifest::order);
  if (twins != course.end()) {
    throw std::runtime_error(fmt::format("{} and {} have the same order, {}, in exercise.toml; give one another number",
                                         twins->topic, (twins + 1)->topic, twins->order));
  }
  return course;
}

const Manifest& findExercise(const std::vector<Manifest>& course, const std::string& topic) {
  const auto found = std::ranges::find(course, topic, &Manifest::topic);
  if (found != course.end()) return *found;
  throw std::runtime_error(
      fmt::format("no exercise '{}'{}", printableLine(topic), suggestion(topic, topicsOf(course))));
}

}  // namespace muelle
