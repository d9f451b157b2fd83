#include "grader/intake/collector.h"

#include "base/text/printable.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <algorithm>
#include <cctype>

namespace muelle::grader {

namespace {

constexpr std::size_t shownNames = 4;
constexpr std::size_t shownNameBytes = 80;

std::string lowerCase(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

/// "a, b, c, d, ..." and nothing of what is not shown.
std::string list(const std::vector<std::string>& names) {
  std::vector<std::string> shown(names.begin(), names.begin() + static_cast<long>(std::min(names.size(), shownNames)));
  if (names.size() > shownNames) shown.emplace_back("...");
  return fmt::format("{}", fmt::join(shown, ", "));
}

}  // namespace

std::string show(const RelativePath& path) {
  return cut(printableLine(fmt::format("{}", fmt::join(path, "/"))), 2 * shownNameBytes);
}

Collector::Collector(const std::vector<Manifest>& course, IntakeLimits limits) : course_(course), limits_(limits) {}

bool Collector::isSkipped(const std::string& component) {
  return component.starts_with('.') || component == "__MACOSX";
}

bool Collector::isHidden(const RelativePath& path) {
  const bool hidden = std::any_of(path.begin(), path.end(), isSkipped);
  if (hidden) ++hidden_;
  return hidden;
}

bool Collector::isTopic(const std::string& name) const {
  return std::any_of(course_.begin(), course_.end(), [&](const Manifest& m) { return m.topic == name; });
}

std::vector<Collector::Key> Collector::wantedBy(const RelativePath& path) const {
  const std::string& name = path.back();
  const std::string parent = path.size() > 1 ? path[path.size() - 2] : "";
  std::vector<Key> keys;
  for (const Manifest& manifest : course_) {
    const bool named = std::find(manifest.files.begin(), manifest.files.end(), name) != manifest.files.end();
    // A file in the folder of another exercise is nobody's: taking it would reward a guess.
    if (named && (parent == manifest.topic || !isTopic(parent))) keys.emplace_back(manifest.topic, name);
  }
  return keys;
}

void Collector::file(const RelativePath& path, const std::function<Content()>& read) {
  if (isHidden(path)) return;
  if (!wantedBy(path).empty()) return offer(path, read);
  if (isHandedOut(path)) {
    ++handedOut_;
  } else {
    ignore(path, misnamed(path.back()));
  }
}

void Collector::notAFile(const RelativePath& path, const std::string& why) {
  if (isHidden(path)) return;
  if (!wantedBy(path).empty()) {
    offer(path, [&] { return Content{"", why}; });
  } else {
    ignore(path, why);
  }
}

void Collector::note(const std::string& what) { notes_.push_back(what); }

void Collector::offer(const RelativePath& path, const std::function<Content()>& read) {
  for (const Key& key : wantedBy(path)) {
    const bool inPlace = path.size() > 1 && path[path.size() - 2] == key.first;
    const std::pair<int, std::size_t> rank{inPlace ? 0 : 1, path.size()};
    Slot& slot = slots_[key];
    if (!slot.places.empty() && rank > slot.rank) {
      ignore(path, "another one counts");
    } else if (!slot.places.empty() && rank == slot.rank) {
      slot.places.push_back(path);
    } else {
      for (const RelativePath& worse : slot.places) ignore(worse, "another one counts");
      slot = Slot{rank, {path}, read()};
    }
  }
}

void Collector::ignore(const RelativePath& path, const std::string& why) {
  const RelativePath folder(path.begin(), path.end() - 1);
  ignored_[{show(folder), why}].push_back(cut(printableLine(path.back()), shownNameBytes));
}

bool Collector::isHandedOut(const RelativePath& path) const {
  if (path.size() < 2 || !isTopic(path[path.size() - 2])) return false;
  const std::string& name = path.back();
  return name == path[path.size() - 2] + ".h" || name == "README.md" || name == "figure.svg" ||
         name == "exercise.toml" || name == "demo.cpp" || name == "public_test.cpp";
}

std::string Collector::misnamed(const std::string& name) const {
  for (const Manifest& manifest : course_) {
    for (const std::string& wanted : manifest.files) {
      if (lowerCase(name) == lowerCase(wanted)) return "should its name be " + wanted + "?";
    }
  }
  return "";
}

std::vector<std::string> Collector::notes() const {
  std::vector<std::string> lines = notes_;
  for (const auto& [place, names] : ignored_) {
    const std::string folder = place.first.empty() ? "" : fmt::format(" in {}/", place.first);
    const std::string why = place.second.empty() ? "" : fmt::format(" ({})", place.second);
    lines.push_back(names.size() == 1
                        ? fmt::format("ignored{}: {}{}", folder, names.front(), why)
                        : fmt::format("ignored {} other files{}: {}{}", names.size(), folder, list(names), why));
  }
  if (handedOut_ > 0)
    lines.push_back(fmt::format("ignored {} files that the course hands out; its own are used", handedOut_));
  if (hidden_ > 0) lines.push_back(fmt::format("ignored {} hidden files or folders", hidden_));
  if (lines.size() > limits_.notes) {
    const std::size_t rest = lines.size() - limits_.notes;
    lines.resize(limits_.notes);
    lines.push_back(fmt::format("... and {} more notes", rest));
  }
  return lines;
}

Submission Collector::finish(std::string name) const {
  Submission submission;
  submission.name = std::move(name);
  for (const auto& [key, slot] : slots_) {
    const auto& [topic, fileName] = key;
    if (slot.places.size() > 1) {
      submission.refused[topic] = fmt::format("{} is there {} times, at {} and {}: hand in one", fileName,
                                              slot.places.size(), show(slot.places[0]), show(slot.places[1]));
    } else if (!slot.content.refusal.empty()) {
      submission.refused[topic] = fmt::format("{} {}", show(slot.places[0]), slot.content.refusal);
    } else {
      submission.sources[topic][fileName] = slot.content.text;
    }
  }
  // A refused file costs its exercise, whatever else of it was fine.
  for (const auto& [topic, why] : submission.refused) submission.sources.erase(topic);
  submission.notes = notes();
  return submission;
}

}  // namespace muelle::grader
