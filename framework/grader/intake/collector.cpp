#include "grader/intake/collector.h"

#include "base/text/count.h"
#include "base/text/lists.h"
#include "base/text/nearest.h"
#include "base/text/printable.h"
#include "course/check/handed_out.h"
#include "course/check/source_text.h"
#include "grader/intake/file_names.h"
#include "grader/intake/package.h"
#include "grader/intake/read_file.h"
#include "grader/run/digest.h"

#include <fmt/format.h>
#include <algorithm>

namespace muelle::grader {

namespace {

static_assert(IntakeLimits{}.sourceBytes == largestSource, "check refuses a file by the same size");

constexpr std::size_t shownNames = 4;
constexpr std::size_t shownNearNames = 3;
constexpr std::size_t shownNameBytes = 80;
constexpr int textRank = 2;  ///< of a name that may be a note's

/// "a, b, c, d, ..." and nothing of what is not shown.
std::string list(const std::vector<std::string>& names) {
  std::vector<std::string> shown(names.begin(), names.begin() + static_cast<long>(std::min(names.size(), shownNames)));
  if (names.size() > shownNames) shown.emplace_back("...");
  return joined(shown, ", ");
}

/// "notes/"; of no path, the folder that was handed in.
std::string shownFolder(const RelativePath& path) { return path.empty() ? "the folder handed in" : show(path) + "/"; }

std::string parentOf(const RelativePath& path) { return path.size() > 1 ? path[path.size() - 2] : ""; }

/// Sources that every exercise hands out; nobody's answer.
bool isHandedOutSource(const std::string& name) { return name == "demo.cpp" || name == "public_test.cpp"; }

/// With one kind of line end.
std::string withoutReturns(std::string text) {
  std::erase(text, '\r');
  return text;
}

/// Whether they differ in line ends at most; of many copies most are equal as they are.
bool isSameText(const std::string& a, const std::string& b) { return a == b || withoutReturns(a) == withoutReturns(b); }

/// Without what an editor or a system changes of itself.
std::string asWritten(std::string text) {
  text = withoutReturns(std::move(text));
  text.erase(text.find_last_not_of(" \t\n") + 1);
  return text;
}

std::string hashOf(const Submission& submission) {
  std::string hash;
  for (const auto& [topic, files] : submission.sources) {
    for (const auto& [name, text] : files) hash = digest({hash, topic, name, text});
  }
  return hash.empty() ? digest({}) : hash;
}

}  // namespace

std::string show(const RelativePath& path) { return cut(printableLine(joined(path, "/")), 2 * shownNameBytes); }

Collector::Collector(const std::vector<Manifest>& course, IntakeLimits limits, std::vector<std::string> only,
                     SourcesByTopic stubs)
    : course_(course), limits_(limits), only_(std::move(only)), stubs_(std::move(stubs)) {}

bool Collector::isHidden(const RelativePath& path) {
  return std::any_of(path.begin(), path.end(), [](const std::string& component) {
    return component.starts_with('.') || component == "__MACOSX";
  });
}

bool Collector::passOver(const RelativePath& path) {
  if (!isHidden(path)) return false;
  ++hidden_;
  const bool isAFork = std::find(path.begin(), path.end(), "__MACOSX") != path.end();
  if (!isAFork && !path.back().starts_with('.'))
    skipped_.emplace_back(path.back(), fmt::format("ignored {}: it lies in a hidden folder", show(path)));
  return true;
}

bool Collector::isAskedFor(const std::string& topic) const {
  return only_.empty() || std::find(only_.begin(), only_.end(), topic) != only_.end();
}

/// The topic that a folder or an archive is named after; "" for none.
std::string Collector::topicOf(const std::string& folder) const {
  const std::string name = withoutArchiveSuffix(folder);
  for (const Manifest& manifest : course_) {
    if (name == manifest.topic) return manifest.topic;
  }
  for (const Manifest& manifest : course_) {
    if (isNearFolderName(name, manifest.topic)) return manifest.topic;
  }
  return "";
}

std::vector<std::pair<Collector::Key, Collector::Rank>> Collector::wantedBy(const RelativePath& path) const {
  const std::string& name = path.back();
  const std::string parent = parentOf(path);
  const std::string home = topicOf(parent);
  std::vector<std::pair<Key, Rank>> exact;
  std::vector<std::pair<Key, Rank>> near;
  bool isAName = false;
  for (const Manifest& manifest : course_) {
    const int place = parent == manifest.topic ? 0 : 1;
    for (const std::string& wanted : manifest.files) {
      isAName |= name == wanted;
      // A file in the folder of another exercise is nobody's: taking it would reward a guess.
      if (!home.empty() && home != manifest.topic) continue;
      const Key key{manifest.topic, wanted};
      if (name == wanted) exact.emplace_back(key, Rank{0, place, path.size()});
      if (isNearName(name, wanted)) near.emplace_back(key, Rank{1, place, path.size()});
      if (isTextNamedAs(name, wanted)) near.emplace_back(key, Rank{textRank, place, path.size()});
    }
  }
  if (isAName) return exact;
  // A name that is near to two says nothing.
  if (near.size() > 1) near.clear();
  return near;
}

/// A source, or what is named as one that is wanted; not a contract, which is handed out under such a name.
bool Collector::mayBeMeant(const std::string& name) const {
  if (isHandedOutSource(name)) return false;
  return isSourceName(name) || std::any_of(course_.begin(), course_.end(), [&](const Manifest& manifest) {
           return name != manifest.topic + ".h" &&
                  std::any_of(manifest.files.begin(), manifest.files.end(),
                              [&](const std::string& wanted) { return isNamedAlike(name, wanted); });
         });
}

void Collector::file(const RelativePath& path, const std::function<Content()>& read) {
  ++seen_;
  if (passOver(path)) return;
  if (!wantedBy(path).empty()) return offer(path, read);
  if (isHandedOut(path)) {
    handedOut(path, read);
  } else {
    if (mayBeMeant(path.back())) strays_.push_back(path);
    ignore(path, "");
  }
}

void Collector::regularFile(const RelativePath& path, std::string_view head, const std::function<Content()>& read) {
  const RelativePath folder(path.begin(), path.end() - 1);
  const bool isPlain = isHidden(folder) || !wantedBy(path).empty();
  const std::optional<StandIn> other = isPlain ? std::nullopt : standIn(path.back(), head);
  if (!other) return file(path, read);
  ++seen_;
  skipped(other->name, fmt::format("ignored {}: {}", show(path), other->why));
}

void Collector::notAFile(const RelativePath& path, const std::string& why) {
  ++seen_;
  if (passOver(path)) return;
  if (!wantedBy(path).empty()) {
    offer(path, [&] { return Content::refused(why); });
  } else {
    ignore(path, why);
  }
}

void Collector::unreadableFolder(const RelativePath& path, const std::string& why) {
  ++seen_;
  unreadable_.push_back({path, why});
  note(fmt::format("{} {}", shownFolder(path), why));
}

void Collector::note(const std::string& what) { notes_.push_back(what); }

void Collector::skipped(const std::string& name, const std::string& what) {
  skipped_.emplace_back(isArchiveName(name) ? "" : name, what);
  note(what);
}

void Collector::offer(const RelativePath& path, const std::function<Content()>& read) {
  for (const auto& [key, rank] : wantedBy(path)) {
    if (isAskedFor(key.first)) add(key, candidate(path, rank, read()));
  }
}

Content Collector::tooLarge() const {
  return Content::refused(fmt::format("is larger than {}", showBytes(limits_.sourceBytes)));
}

Content Collector::contentOf(const std::optional<std::string>& bytes) const {
  return bytes && bytes->size() <= limits_.sourceBytes ? Content{*bytes} : tooLarge();
}

Collector::Candidate Collector::candidate(const RelativePath& path, const Rank& rank, Content content) const {
  SourceText source = readSource(std::move(content.bytes));
  content.bytes = std::move(source.text);
  if (content.refusal.empty()) content.refusal = std::move(source.refusal);
  if (content.bytes.size() > limits_.sourceBytes) content = tooLarge();
  return {rank, path, std::move(content), std::move(source.note)};
}

bool Collector::isStub(const Key& key, const Content& content) const {
  if (!content.refusal.empty() || !content.fault.empty()) return false;
  const auto topic = stubs_.find(key.first);
  if (topic == stubs_.end()) return false;
  const auto file = topic->second.find(key.second);
  return file != topic->second.end() && asWritten(file->second) == asWritten(content.bytes);
}

void Collector::add(const Key& key, Candidate found) {
  const auto mayBeANote = [](const Candidate& one) { return std::get<0>(one.rank) == textRank; };
  Slot& slot = slots_[key];
  if (isStub(key, found.content)) {
    if (!slot.stub || found.rank < slot.stub->rank) slot.stub = std::move(found);
  } else if (slot.best && mayBeANote(found) && !mayBeANote(*slot.best)) {
    ignore(found.path, "another one counts");
  } else if (slot.best && !mayBeANote(found) && mayBeANote(*slot.best)) {
    ignore(slot.best->path, "another one counts");
    if (slot.other) ignore(slot.other->path, "another one counts");
    slot = Slot{{}, {}, std::move(slot.stub)};
    addToOthers(slot, std::move(found));
  } else {
    addToOthers(slot, std::move(found));
  }
}

/// Only one text is kept: a submission of ten thousand copies takes no more room than one.
void Collector::addToOthers(Slot& slot, Candidate found) {
  ++slot.places;
  if (slot.fault.empty() && !found.content.fault.empty())
    slot.fault = fmt::format("{} {}", show(found.path), found.content.fault);
  if (slot.other) return;  // two differ already
  if (!slot.best) {
    slot.best = std::move(found);
  } else if (isSameText(found.content.bytes, slot.best->content.bytes) &&
             found.content.refusal == slot.best->content.refusal) {
    if (found.rank < slot.best->rank) slot.best = std::move(found);
  } else {
    found.content.bytes.clear();
    slot.other = std::move(found);
  }
}

/// Of an exercise that is not asked for: in its folder, however deep, or named as its contract.
bool Collector::isOfAnother(const RelativePath& path) const {
  if (only_.empty()) return false;
  for (auto folder = path.rbegin() + 1; folder != path.rend(); ++folder) {
    if (const std::string topic = topicOf(*folder); !topic.empty()) return !isAskedFor(topic);
  }
  return std::ranges::any_of(course_, [&](const Manifest& manifest) {
    return path.back() == manifest.topic + ".h" && !isAskedFor(manifest.topic);
  });
}

void Collector::ignore(const RelativePath& path, const std::string& why) {
  if (isOfAnother(path)) return;
  const RelativePath folder(path.begin(), path.end() - 1);
  ignored_[{show(folder), why}].push_back(cut(printableLine(path.back()), shownNameBytes));
}

bool Collector::isHandedOut(const RelativePath& path) const {
  const std::string topic = topicOf(parentOf(path));
  if (topic.empty()) return false;
  const std::string& name = path.back();
  return name == topic + ".h" || name == "README.md" || name == "README.es.md" || name == "figure.svg" ||
         name == "exercise.toml" || isHandedOutSource(name);
}

void Collector::handedOut(const RelativePath& path, const std::function<Content()>& read) {
  const std::string topic = topicOf(parentOf(path));
  if (!isAskedFor(topic)) return;
  ++handedOut_;
  if (path.back() != topic + ".h") return;
  const Content content = read();
  if (content.refusal.empty() && content.fault.empty()) contracts_[topic].insert(handedOutHash(content.bytes));
}

std::vector<std::string> Collector::notes(const Submission& submission) const {
  std::vector<std::string> lines;
  for (const auto& [topic, how] : submission.taken) lines.push_back(how);
  lines.insert(lines.end(), notes_.begin(), notes_.end());
  for (const auto& [place, names] : ignored_) {
    const std::string folder = place.first.empty() ? "" : fmt::format(" in {}/", place.first);
    const std::string why = place.second.empty() ? "" : fmt::format(" ({})", place.second);
    lines.push_back(names.size() == 1
                        ? fmt::format("ignored{}: {}{}", folder, names.front(), why)
                        : fmt::format("ignored {} other files{}: {}{}", names.size(), folder, list(names), why));
  }
  if (handedOut_ > 0)
    lines.push_back(fmt::format("ignored {} that the course hands out; its own are used",
                                counted(static_cast<long long>(handedOut_), "file")));
  if (hidden_ > 0)
    lines.push_back("ignored " +
                    counted(static_cast<long long>(hidden_), "hidden file or folder", "hidden files or folders"));
  if (lines.size() > limits_.notes) {
    const std::size_t rest = lines.size() - limits_.notes;
    lines.resize(limits_.notes);
    lines.push_back(fmt::format("... and {} more notes", rest));
  }
  return lines;
}

/// The sources that may be meant by `file`, best first: what lies in the exercise's folder; what is spelled alike; else
/// the few that there are, when nothing tells which exercise they are for.
std::vector<std::string> Collector::near(const std::string& topic, const std::string& file) const {
  std::vector<std::string> stems;
  for (const Manifest& manifest : course_) {
    for (const std::string& wanted : manifest.files) stems.push_back(plainStem(wanted));
  }
  std::vector<std::string> inFolder;
  std::vector<std::string> alike;
  std::vector<std::string> others;
  for (const RelativePath& stray : strays_) {
    const std::string home = topicOf(parentOf(stray));
    const std::string guess = nearest(plainStem(stray.back()), stems);
    if (home == topic) {
      inFolder.push_back(show(stray));
    } else if (guess == plainStem(file) || isNamedAlike(stray.back(), file)) {
      alike.push_back(show(stray));
    } else if (home.empty() && guess.empty()) {
      others.push_back(show(stray));
    }
  }
  if (!inFolder.empty()) return inFolder;
  if (!alike.empty()) return alike;
  const bool isTheirs = others.size() <= shownNearNames && (slots_.empty() || unfound() == 1);
  return isTheirs ? others : std::vector<std::string>{};
}

std::size_t Collector::unfound() const {
  std::size_t count = 0;
  for (const Manifest& manifest : course_) {
    for (const std::string& file : manifest.files) {
      if (isAskedFor(manifest.topic) && !slots_.contains({manifest.topic, file})) ++count;
    }
  }
  return count;
}

/// Why what may be that file, or hold it, was passed over; "" when there is nothing of the kind.
std::string Collector::whySkipped(const std::string& file) const {
  for (const auto& [name, why] : skipped_) {
    if (name.empty() || name == file || isNearName(name, file)) return fmt::format("no {}; {}", file, why);
  }
  if (seen_ == 0 && !skipped_.empty())
    return fmt::format("no {}: all that was handed in is passed over; {}", file, skipped_.front().second);
  return "";
}

std::string Collector::missing(const std::string& topic, const std::string& file) const {
  if (seen_ == 0) return fmt::format("no {}: the submission is empty", file);
  std::vector<std::string> names = near(topic, file);
  if (names.empty()) return fmt::format("no {}", file);
  if (names.size() == 1) return fmt::format("no {}; is '{}' meant?", file, names.front());
  const bool isCut = names.size() > shownNearNames;
  if (isCut) names.resize(shownNearNames);
  return fmt::format("no {}; is one of '{}'{} meant?", file, joined(names, "', '"), isCut ? ", ..." : "");
}

/// The unreadable folder in which a file may lie that would go before the one found; null when there is none.
const Collector::UnreadableFolder* Collector::mayHide(const std::string& topic, const std::string& file) const {
  const auto slot = slots_.find({topic, file});
  for (const UnreadableFolder& folder : unreadable_) {
    const std::string home = folder.path.empty() ? "" : topicOf(folder.path.back());  // empty: the submission itself
    if (!home.empty() && home != topic) continue;
    const Rank best{0, 0, folder.path.size() + (home == topic ? 1 : 2)};
    if (slot == slots_.end() || !slot->second.best || best <= slot->second.best->rank) return &folder;
  }
  return nullptr;
}

/// What a slot comes to.
void Collector::settle(const Key& key, const Slot& slot, Submission& submission) {
  const auto& [topic, file] = key;
  if (!slot.fault.empty()) {
    submission.faults[topic] = slot.fault;
  } else if (slot.other) {
    submission.refused[topic] = differing(file, slot);
  } else if (slot.best && !slot.best->content.refusal.empty()) {
    submission.refused[topic] = fmt::format("{} {}", show(slot.best->path), slot.best->content.refusal);
  } else {
    take(key, slot, submission);
  }
}

std::string Collector::differing(const std::string& file, const Slot& slot) {
  const auto named = [](const Candidate& one) {
    const std::string why = one.content.refusal.empty() ? "" : fmt::format(" ({})", one.content.refusal);
    return fmt::format("'{}'{}", show(one.path), why);
  };
  const bool isSwapped = slot.other->rank < slot.best->rank;
  const Candidate& first = isSwapped ? *slot.other : *slot.best;
  const Candidate& second = isSwapped ? *slot.best : *slot.other;
  const std::string start = std::get<0>(first.rank) == 0 ? fmt::format("{} is there {} times", file, slot.places)
                                                         : fmt::format("no {}", file);
  return fmt::format("{}, and {} and {} differ: hand in one, named {}", start, named(first), named(second), file);
}

void Collector::take(const Key& key, const Slot& slot, Submission& submission) {
  const auto& [topic, file] = key;
  const Candidate& taken = slot.best ? *slot.best : *slot.stub;
  submission.sources[topic][file] = taken.content.bytes;
  const bool isBesideAStub = slot.best && slot.stub;
  const std::string stub =
      isBesideAStub ? fmt::format(", since '{}' is the stub as handed out", show(slot.stub->path)) : "";
  std::vector<std::string> said;
  if (isBesideAStub || std::get<0>(taken.rank) != 0)
    said.push_back(fmt::format("is taken from '{}'{}", show(taken.path), stub));
  if (slot.places > 1) said.push_back(fmt::format("is there {} times, all equal", slot.places));
  if (!taken.note.empty()) said.push_back(taken.note);
  if (said.empty()) return;
  std::string& how = submission.taken[topic];
  how += fmt::format("{}{} {}", how.empty() ? "" : "; ", file, joined(said, "; "));
}

/// One exercise: its files, or why there are none.
void Collector::say(const Manifest& manifest, Submission& submission) const {
  const std::string& topic = manifest.topic;
  for (const std::string& file : manifest.files) {
    const auto slot = slots_.find({topic, file});
    if (const UnreadableFolder* folder = mayHide(topic, file)) {
      submission.faults[topic] = fmt::format("{}, where {} may lie, {}", shownFolder(folder->path), file, folder->why);
    } else if (slot != slots_.end()) {
      settle(slot->first, slot->second, submission);
    } else if (const std::string why = whySkipped(file); !why.empty()) {
      submission.refused[topic] = why;
    } else if (!submission.missing.contains(topic)) {
      submission.missing[topic] = missing(topic, file);
    }
  }
  // A file that is refused costs its exercise, whatever else of it was fine.
  const bool isFault = submission.faults.contains(topic);
  if (isFault) submission.refused.erase(topic);
  const bool isRefused = submission.refused.contains(topic);
  if (isFault || isRefused) {
    submission.missing.erase(topic);
    submission.taken.erase(topic);
    submission.sources.erase(topic);
  }
}

Submission Collector::finish(std::string name) const {
  Submission submission;
  submission.name = std::move(name);
  for (const Manifest& manifest : course_) {
    if (isAskedFor(manifest.topic)) say(manifest, submission);
  }
  submission.contracts = contracts_;
  submission.notes = notes(submission);
  submission.hash = hashOf(submission);
  return submission;
}

}  // namespace muelle::grader
