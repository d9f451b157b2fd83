#include "lab/advise/applied_scene.h"

#include "base/file.h"
#include "base/toml/value.h"
#include "lab/advise/listed_scene.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <algorithm>
#include <optional>
#include <stdexcept>

namespace muelle::lab {

using namespace engine;

namespace {

namespace fs = std::filesystem;

std::string trimmed(const std::string& line) {
  const std::size_t first = line.find_first_not_of(" \t\r");
  return first == std::string::npos ? "" : line.substr(first);
}

/// A scene file as lines that are changed by table and key.
class SceneLines {
 public:
  explicit SceneLines(const fs::path& file) : name_(file.string()), root_(readToml(file, name_)) {
    std::string text = readFile(file), line;
    for (const char c : text) {
      if (c == '\n') {
        lines_.push_back(std::exchange(line, ""));
      } else {
        line += c;
      }
    }
    if (!line.empty()) lines_.push_back(line);
    gone_.assign(lines_.size(), false);
    added_.assign(lines_.size() + 1, "");
  }

  /// The tables of [[name]], or the one of [name].
  std::vector<const TomlValue*> tables(const char* name) const {
    std::vector<const TomlValue*> found;
    if (const TomlValue* value = root_.find(name); value != nullptr) {
      if (value->kind == TomlValue::Kind::Table) found.push_back(value);
      for (const TomlValue& item : value->list) found.push_back(&item);
    }
    return found;
  }

  /// Takes "key = value" out of a table; nothing where it is not there.
  void remove(const TomlValue& table, const std::string& key) {
    if (const TomlValue* value = table.find(key); value != nullptr) gone_[lineWith(*value, key)] = true;
  }
  void replace(const TomlValue& table, const char* key, const std::string& value) {
    const TomlValue* old = table.find(key);
    if (old == nullptr) throw std::logic_error(std::string("no key ") + key);
    lines_[lineWith(*old, key)] = fmt::format("{} = {}", key, value);
  }
  /// Adds a line below the one with this key.
  void addBelow(const TomlValue& table, const char* key, const std::string& text) {
    added_[lineWith(*table.find(key), key) + 1] += text + "\n";
  }
  /// Sets a key of the whole scene, which has a title.
  void setOfScene(const char* key, const std::string& value) {
    if (root_.find(key) != nullptr) return replace(root_, key, value);
    addBelow(root_, "title", fmt::format("{} = {}", key, value));
  }
  void addAtEnd(const std::string& text) { added_.back() += text; }
  /// Takes a whole table [[name]] out, but for the comments above the next one.
  void removeTable(const TomlValue& table) {
    const auto first = static_cast<std::size_t>(table.line - 1);
    if (!trimmed(lines_.at(first)).starts_with("[[")) fail(table.line);
    std::size_t end = first + 1;
    while (end < lines_.size() && !trimmed(lines_[end]).starts_with("[")) ++end;
    while (end > first + 1 && (trimmed(lines_[end - 1]).empty() || trimmed(lines_[end - 1]).starts_with("#"))) --end;
    for (std::size_t i = first; i < end; ++i) gone_[i] = true;
  }

  std::string text() const {
    std::string all;
    for (std::size_t i = 0; i < lines_.size(); ++i) {
      all += added_[i];
      if (!gone_[i]) all += lines_[i] + "\n";
    }
    return all + added_.back();
  }

 private:
  [[noreturn]] void fail(int line) const {
    throw std::runtime_error(fmt::format(
        "--apply: {}:{}: only what stands on lines of its own can be changed: write tables as [[...]]", name_, line));
  }
  std::size_t lineWith(const TomlValue& value, const std::string& key) const {
    const auto at = static_cast<std::size_t>(value.line - 1);
    const std::string line = trimmed(lines_.at(at));
    const std::size_t equals = line.find('=');
    // One key a line, its value on the same line.
    if (!line.starts_with(key) || equals == std::string::npos || trimmed(line.substr(key.size())).front() != '=') {
      fail(value.line);
    }
    return at;
  }

  std::string name_;
  TomlValue root_;
  std::vector<std::string> lines_;
  std::vector<bool> gone_;
  std::vector<std::string> added_;  ///< before each line, and behind the last
};

void removeEverywhere(SceneLines& lines, std::initializer_list<const char*> keys) {
  for (const char* name : {"object", "node", "spring"}) {
    for (const TomlValue* table : lines.tables(name)) {
      for (const char* key : keys) lines.remove(*table, key);
    }
  }
}

/// The objects of that name, with the names that objects without one have.
void removeFromObject(SceneLines& lines, const std::string& object, const std::string& key) {
  int number = 0;
  for (const TomlValue* table : lines.tables("object")) {
    ++number;
    const TomlValue* name = table->find("name");
    const std::string own = name != nullptr ? name->text : fmt::format("{}{}", table->find("kind")->text, number);
    if (own == object) lines.remove(*table, key);
  }
}

void leaveOut(SceneLines& lines, const Simplification& part) {
  switch (part.kind) {
    case Simplification::Kind::Axis:
      break;  // another file altogether
    case Simplification::Kind::Contact:
      lines.removeTable(*lines.tables("obstacle").at(part.obstacle));
      break;
    case Simplification::Kind::Damping:
      removeEverywhere(lines, {"relative_damping", "projected_damping", "damping_ratio"});
      break;
    case Simplification::Kind::Drag:
      removeEverywhere(lines, {"drag"});
      break;
    case Simplification::Kind::Elements:
      removeFromObject(lines, part.object, part.key);
      break;
    case Simplification::Kind::Digits:
      lines.setOfScene("precision", "\"single\"");
      break;
    case Simplification::Kind::Motion:
      lines.addAtEnd(fmt::format("\n[[pin]]\nnodes = [{}]\n", fmt::join(part.nodes, ", ")));
      break;
  }
}

void setRun(SceneLines& lines, const Setting& setting) {
  const TomlValue& run = *lines.tables("run").at(0);
  lines.replace(run, "method", fmt::format("\"{}\"", setting.method));
  lines.remove(run, "step");
  lines.remove(run, "tolerance");
  lines.addBelow(run, "method", fmt::format("{} = {}", setting.fixed ? "step" : "tolerance", setting.value));
}

/// Meshes are beside the scene: named from another folder they are elsewhere.
void moveMeshes(SceneLines& lines, const fs::path& from, const fs::path& to) {
  for (const TomlValue* table : lines.tables("object")) {
    const TomlValue* mesh = table->find("mesh");
    if (mesh == nullptr || fs::path(mesh->text).is_absolute()) continue;
    const fs::path moved = fs::relative(fs::weakly_canonical(from / mesh->text), fs::weakly_canonical(to));
    if (moved != fs::path(mesh->text)) lines.replace(*table, "mesh", fmt::format("\"{}\"", moved.generic_string()));
  }
}

/// Whether what was written says what was meant.
bool agrees(const Scene& read, const Scene& meant) {
  return read.method == meant.method && read.step == meant.step && read.tolerance == meant.tolerance &&
         read.model.springs.size() == meant.model.springs.size() &&
         read.model.obstacles.size() == meant.model.obstacles.size() &&
         read.model.nodes.size() == meant.model.nodes.size() && read.model.precision == meant.model.precision;
}

fs::path folderOf(const fs::path& file) { return file.has_parent_path() ? file.parent_path() : fs::path("."); }

}  // namespace

AppliedScene appliedScene(const fs::path& file, const Advice& advice, const fs::path& folder) {
  const Candidate* chosen = advice.chosen();
  if (chosen == nullptr) throw std::invalid_argument("--apply: there is no choice to write");
  AppliedScene applied;
  std::vector<Simplification> parts = advice.leftOut();
  const auto axis = std::ranges::find(parts, Simplification::Kind::Axis, &Simplification::kind);
  if (axis != parts.end()) {
    const std::string problem = unlisted(advice.scene);
    if (problem.empty()) {
      applied.text = listedScene(advice.scene);
      return applied;
    }
    applied.notSaid.push_back(fmt::format("{}: {}", axis->name, problem));
    parts.erase(axis);
  }
  SceneLines lines(file);
  setRun(lines, chosen->setting);
  for (const Simplification& part : parts) leaveOut(lines, part);
  moveMeshes(lines, folderOf(file), folder);
  applied.text = lines.text();
  return applied;
}

void checkTarget(const fs::path& file, const fs::path& target) {
  std::error_code error;
  if (fs::equivalent(file, target, error)) {
    throw std::invalid_argument(
        fmt::format("--apply {}: is the scene itself, and stays as it is; give another name", target.string()));
  }
  if (target.extension() != ".toml") {
    throw std::invalid_argument(fmt::format("--apply {}: a scene file ends in .toml", target.string()));
  }
  if (!fs::is_directory(folderOf(target))) {
    throw std::invalid_argument(fmt::format("--apply {}: there is no such folder", target.string()));
  }
}

AppliedScene writeApplied(const fs::path& file, const Advice& advice, const fs::path& target) {
  checkTarget(file, target);
  const AppliedScene applied = appliedScene(file, advice, folderOf(target));
  writeFile(target, applied.text);
  Scene meant = advice.scene;
  if (!agrees(readScene(target), meant)) {
    throw std::logic_error(fmt::format("{} does not say what was meant", target.string()));
  }
  return applied;
}

}  // namespace muelle::lab
