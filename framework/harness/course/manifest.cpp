#include "harness/course/manifest.h"

#include "harness/text/nearest.h"

#include <fmt/format.h>
#include <toml++/toml.h>
#include <algorithm>
#include <cmath>
#include <functional>
#include <set>
#include <stdexcept>
#include <utility>

namespace muelle {

namespace {

using Keys = std::vector<std::string>;

/// One file being read: gives every complaint its place.
class ManifestReader {
 public:
  explicit ManifestReader(const std::filesystem::path& file)
      : shown_((file.parent_path().filename() / file.filename()).string()) {}

  [[noreturn]] void fail(toml::source_index line, const std::string& complaint) const {
    throw std::runtime_error(fmt::format("{}:{}: {}", shown_, std::max<toml::source_index>(line, 1), complaint));
  }
  [[noreturn]] void fail(const toml::node& node, const std::string& key, const std::string& complaint) const {
    fail(node.source().begin.line, fmt::format("key '{}': {}", key, complaint));
  }

  /// Unknown keys first: a misspelt key is also a missing one, and the misspelling is what to mend.
  void checkKeys(const toml::table& table, const Keys& known, const Keys& required) const {
    for (const auto& [key, node] : table) {
      const std::string name(key.str());
      if (std::ranges::find(known, name) != known.end()) continue;
      const std::string guess = didYouMean(name, known);
      fail(key.source().begin.line,
           fmt::format("key '{}': unknown{}", name, guess.empty() ? "; known are " + list(known) : guess));
    }
    for (const std::string& name : required) {
      if (!table.contains(name)) fail(table.source().begin.line, fmt::format("key '{}': missing", name));
    }
  }

  std::string text(const toml::table& table, const std::string& key) const {
    const toml::node& node = *table.get(key);
    if (!node.is_string()) failType(node, key, "a text in quotes");
    const std::string value = **node.as_string();
    if (value.find_first_not_of(" \t") == std::string::npos) fail(node, key, "is empty");
    if (std::ranges::any_of(value, [](unsigned char c) { return c < 0x20 || c == 0x7F; })) {
      fail(node, key, "must be one line without control characters");
    }
    return value;
  }

  double points(const toml::table& table) const {
    const toml::node& node = *table.get("points");
    const std::optional<double> value = node.is_number() ? node.value<double>() : std::nullopt;
    if (!value) failType(node, "points", "a number");
    if (!std::isfinite(*value) || *value <= 0) fail(node, "points", "must be positive");
    return *value;
  }

  int integer(const toml::table& table, const std::string& key) const {
    const toml::node& node = *table.get(key);
    if (!node.is_integer()) failType(node, key, "an integer");
    const std::int64_t value = **node.as_integer();
    if (value < 0 || value > 1'000'000) fail(node, key, "must lie between 0 and 1000000");
    return static_cast<int>(value);
  }

  bool flag(const toml::table& table, const std::string& key) const {
    const toml::node* node = table.get(key);
    if (node == nullptr) return false;
    if (!node->is_boolean()) failType(*node, key, "true or false");
    return **node->as_boolean();
  }

  /// A list of texts, each of which must please `isGood`.
  std::vector<std::string> texts(const toml::table& table, const std::string& key,
                                 const std::function<bool(const std::string&)>& isGood,
                                 const std::string& expected) const {
    const toml::node* node = table.get(key);
    if (node == nullptr) return {};
    if (!node->is_array()) failType(*node, key, "a list of texts, [\"...\", \"...\"]");
    std::vector<std::string> values;
    for (const toml::node& element : *node->as_array()) {
      if (!element.is_string()) failType(element, key, "a list of texts, [\"...\", \"...\"]");
      const std::string value = **element.as_string();
      if (!isGood(value)) fail(element, key, fmt::format("'{}' is not {}", value, expected));
      if (std::ranges::find(values, value) != values.end()) fail(element, key, fmt::format("'{}' stands twice", value));
      values.push_back(value);
    }
    if (values.empty()) fail(*node, key, "is empty");
    return values;
  }

  /// The tables of [[key]].
  std::vector<const toml::table*> tables(const toml::table& table, const std::string& key) const {
    const toml::node* node = table.get(key);
    if (node == nullptr) return {};
    std::vector<const toml::table*> result;
    if (!node->is_array()) failType(*node, key, fmt::format("tables, each begun by [[{}]]", key));
    for (const toml::node& element : *node->as_array()) {
      if (!element.is_table()) failType(element, key, fmt::format("tables, each begun by [[{}]]", key));
      result.push_back(element.as_table());
    }
    return result;
  }

  static std::string list(const Keys& names) { return fmt::format("{}", fmt::join(names, ", ")); }

 private:
  static std::string typeName(const toml::node& node) {
    if (node.is_string()) return "a text";
    if (node.is_integer()) return "an integer";
    if (node.is_number()) return "a number";
    if (node.is_boolean()) return "true or false";
    if (node.is_array()) return "a list";
    if (node.is_table()) return "a table";
    return "a date or time";
  }
  [[noreturn]] void failType(const toml::node& node, const std::string& key, const std::string& expected) const {
    fail(node, key, fmt::format("expected {}, found {}", expected, typeName(node)));
  }

  std::string shown_;
};

bool isLowerName(const std::string& name) {
  const auto isAllowed = [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_'; };
  return !name.empty() && name[0] >= 'a' && name[0] <= 'z' && std::ranges::all_of(name, isAllowed);
}

bool isIdentifier(const std::string& name) {
  const auto isLetter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  const auto isAllowed = [&](char c) { return isLetter(c) || (c >= '0' && c <= '9') || c == '_'; };
  return !name.empty() && isLetter(name[0]) && std::ranges::all_of(name, isAllowed);
}

bool isSourceName(const std::string& name) {
  return name.size() > 4 && name.ends_with(".cpp") && isIdentifier(name.substr(0, name.size() - 4));
}

Criterion readCriterion(const ManifestReader& reader, const toml::table& table) {
  reader.checkKeys(table, {"name", "suite", "points", "partial", "functions", "hint"},
                   {"name", "suite", "points", "functions", "hint"});
  Criterion criterion;
  criterion.name = reader.text(table, "name");
  criterion.suite = reader.text(table, "suite");
  // GoogleTest forbids underscores in suite names: it makes its own names with them.
  if (!isIdentifier(criterion.suite) || criterion.suite.find('_') != std::string::npos) {
    reader.fail(*table.get("suite"), "suite",
                fmt::format("'{}' is not the name of a GoogleTest suite (letters and digits)", criterion.suite));
  }
  criterion.points = reader.points(table);
  criterion.partial = reader.flag(table, "partial");
  criterion.functions = reader.texts(table, "functions", isIdentifier, "the name of a function");
  criterion.hint = reader.text(table, "hint");
  return criterion;
}

Misconception readMisconception(const ManifestReader& reader, const toml::table& table) {
  const Keys keys{"id", "function", "says", "hint"};
  reader.checkKeys(table, keys, keys);
  Misconception misconception{reader.text(table, "id"), reader.text(table, "function"), reader.text(table, "says"),
                              reader.text(table, "hint")};
  if (!isLowerName(misconception.id)) {
    reader.fail(*table.get("id"), "id", fmt::format("'{}' has other characters than a-z, 0-9, _", misconception.id));
  }
  if (!isIdentifier(misconception.function)) {
    reader.fail(*table.get("function"), "function",
                fmt::format("'{}' is not the name of a function", misconception.function));
  }
  return misconception;
}

FeedbackLevel readFeedback(const ManifestReader& reader, const toml::table& table) {
  if (!table.contains("feedback")) return FeedbackLevel::Values;
  const std::string value = reader.text(table, "feedback");
  if (value == "criterion") return FeedbackLevel::Criterion;
  if (value == "property") return FeedbackLevel::Property;
  if (value == "values") return FeedbackLevel::Values;
  reader.fail(*table.get("feedback"), "feedback", fmt::format("'{}' is not one of criterion, property, values", value));
}

void readCriteria(const ManifestReader& reader, const toml::table& table, Manifest& manifest) {
  std::set<std::string> suites;
  double sum = 0.0;
  for (const toml::table* one : reader.tables(table, "criterion")) {
    const Criterion criterion = readCriterion(reader, *one);
    if (!suites.insert(criterion.suite).second) {
      reader.fail(*one->get("suite"), "suite",
                  fmt::format("'{}' is already that of another criterion", criterion.suite));
    }
    sum += criterion.points;
    manifest.criteria.push_back(criterion);
  }
  if (manifest.criteria.empty()) reader.fail(1, "key 'criterion': at least one [[criterion]] is needed");
  if (std::abs(sum - manifest.points) > 1e-9) {
    reader.fail(*table.get("points"), "points",
                fmt::format("{} is not the sum of the criteria's points, {}", manifest.points, sum));
  }
}

void readMisconceptions(const ManifestReader& reader, const toml::table& table, Manifest& manifest) {
  std::set<std::pair<std::string, std::string>> known;
  for (const toml::table* one : reader.tables(table, "misconception")) {
    const Misconception misconception = readMisconception(reader, *one);
    if (!known.insert({misconception.id, misconception.function}).second) {
      reader.fail(*one->get("id"), "id",
                  fmt::format("'{}' is already that of another misconception of that function", misconception.id));
    }
    manifest.misconceptions.push_back(misconception);
  }
}

Manifest interpret(const ManifestReader& reader, const toml::table& table, const std::string& topic) {
  reader.checkKeys(table, {"order", "title", "points", "files", "feedback", "slides", "criterion", "misconception"},
                   {"order", "title", "points", "files", "criterion"});
  if (!isLowerName(topic)) {
    reader.fail(1, fmt::format("the folder's name '{}' is the topic: it may have a-z, 0-9 and _ only", topic));
  }
  const auto isAnyText = [](const std::string& value) { return !value.empty(); };
  Manifest manifest;
  manifest.topic = topic;
  manifest.order = reader.integer(table, "order");
  manifest.title = reader.text(table, "title");
  manifest.points = reader.points(table);
  manifest.files = reader.texts(table, "files", isSourceName, "a plain file name that ends in .cpp");
  manifest.feedback = readFeedback(reader, table);
  manifest.slides = reader.texts(table, "slides", isAnyText, "the title of a slide");
  readCriteria(reader, table, manifest);
  readMisconceptions(reader, table, manifest);
  return manifest;
}

std::vector<std::string> topicsOf(const std::vector<Manifest>& course) {
  std::vector<std::string> topics;
  for (const Manifest& manifest : course) topics.push_back(manifest.topic);
  return topics;
}

}  // namespace

Manifest readManifest(const std::filesystem::path& file) {
  const ManifestReader reader(file);
  try {
    return interpret(reader, toml::parse_file(file.string()), file.parent_path().filename().string());
  } catch (const toml::parse_error& error) {
    reader.fail(error.source().begin.line, std::string(error.description()));
  }
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
  const std::vector<std::string> topics = topicsOf(course);
  const std::string guess = didYouMean(topic, topics);
  throw std::runtime_error(
      fmt::format("no exercise '{}'{}", topic, guess.empty() ? "; there are " + ManifestReader::list(topics) : guess));
}

}  // namespace muelle
