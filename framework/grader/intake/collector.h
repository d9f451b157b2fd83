#pragma once
#include "grader/intake/intake.h"

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

namespace muelle::grader {

/// A path inside a submission, split at "/"; no empty, "." or ".." components. Untrusted bytes.
using RelativePath = std::vector<std::string>;

/// "spring_1d/spring_1d.cpp", printable and cut.
std::string show(const RelativePath& path);

/// What reading a file gave: its bytes, or the reason why there are none. The reasons complete "spring_1d.cpp ...".
struct Content {
  std::string bytes;
  std::string refusal{};  ///< the submission's: "is larger than 256 KiB"
  std::string fault{};    ///< this machine's: "cannot be read: Permission denied"

  static Content refused(std::string why) { return {"", std::move(why), ""}; }
  static Content unreadable(std::string why) { return {"", "", std::move(why)}; }
};

/// Chooses, among all that a submission holds, the files that count. Every place of a wanted file is a candidate, near
/// names too; equal ones count once, and where two differ none counts, for nobody can tell which one was meant. Two
/// kinds count only where there is nothing else: a stub as it was handed out, and "spring_1d.txt", which may be a note.
class Collector {
 public:
  /// `only`: the topics asked for; all when empty. `stubs`: the files as handed out. `course` must outlive this.
  Collector(const std::vector<Manifest>& course, IntakeLimits limits, std::vector<std::string> only = {},
            SourcesByTopic stubs = {});

  const IntakeLimits& limits() const { return limits_; }

  /// What was read of a file, refused when a source cannot be so long; nullopt: so long that nobody read it.
  Content contentOf(const std::optional<std::string>& bytes) const;

  /// A regular file; `read` is called only when its content may count.
  void file(const RelativePath& path, const std::function<Content()>& read);

  /// The same for a file that may stand for another (see standIn()), as its first bytes tell.
  void regularFile(const RelativePath& path, std::string_view head, const std::function<Content()>& read);

  /// Something else with a name: `why` completes "spring_1d.cpp ...": "is a symbolic link". Refused where a file is
  /// wanted, ignored elsewhere.
  void notAFile(const RelativePath& path, const std::string& why);

  /// A folder that this machine cannot look into: whatever it may hold is unknown. `why` as in Content::fault.
  void unreadableFolder(const RelativePath& path, const std::string& why);

  /// Anything that is ignored for a reason of its own; `what` is a printable line.
  void note(const std::string& what);

  /// The same for what may be a wanted file, or hold one: the reason then stands with the file that is missing. `name`
  /// is its own name; "" when it may hold anything.
  void skipped(const std::string& name, const std::string& what);

  /// True for what never is or holds a hand-in: hidden files and folders, and the Mac's resource forks.
  static bool isHidden(const RelativePath& path);

  Submission finish(std::string name) const;

 private:
  /// 0 the exact name, 1 a near one, 2 a text that may be a note; 0 in its folder, 1 flat; then the depth.
  using Rank = std::tuple<int, int, std::size_t>;
  /// One place of a wanted file, read as text.
  struct Candidate {
    Rank rank;
    RelativePath path;
    Content content;
    std::string note{};  ///< what reading it changed
  };
  struct Slot {
    std::optional<Candidate> best;   ///< of those that equal the first one, that in the best place
    std::optional<Candidate> other;  ///< one that differs, without its bytes
    std::optional<Candidate> stub;   ///< one that is as it was handed out
    std::string fault{};             ///< why this machine cannot read one of them
    std::size_t places = 0;          ///< of them all, the stub aside
  };
  struct UnreadableFolder {
    RelativePath path;
    std::string why;
  };
  using Key = std::pair<std::string, std::string>;  ///< topic, file

  std::vector<std::pair<Key, Rank>> wantedBy(const RelativePath& path) const;
  std::string topicOf(const std::string& folder) const;
  bool isAskedFor(const std::string& topic) const;
  void offer(const RelativePath& path, const std::function<Content()>& read);
  Content tooLarge() const;
  Candidate candidate(const RelativePath& path, const Rank& rank, Content content) const;
  void add(const Key& key, Candidate found);
  static void addToOthers(Slot& slot, Candidate found);
  bool isStub(const Key& key, const Content& content) const;
  bool isOfAnother(const RelativePath& path) const;
  /// Says so, unless it is of an exercise that is not asked for.
  void ignore(const RelativePath& path, const std::string& why);
  /// isHidden(), and counts it.
  bool passOver(const RelativePath& path);
  bool isHandedOut(const RelativePath& path) const;
  bool mayBeMeant(const std::string& name) const;
  /// Counts it, and keeps what a contract's text comes to.
  void handedOut(const RelativePath& path, const std::function<Content()>& read);

  static void settle(const Key& key, const Slot& slot, Submission& submission);
  static std::string differing(const std::string& file, const Slot& slot);
  static void take(const Key& key, const Slot& slot, Submission& submission);
  void say(const Manifest& manifest, Submission& submission) const;
  std::string missing(const std::string& topic, const std::string& file) const;
  std::string whySkipped(const std::string& file) const;
  std::vector<std::string> near(const std::string& topic, const std::string& file) const;
  const UnreadableFolder* mayHide(const std::string& topic, const std::string& file) const;
  std::size_t unfound() const;
  std::vector<std::string> notes(const Submission& submission) const;

  const std::vector<Manifest>& course_;
  IntakeLimits limits_;
  std::vector<std::string> only_;
  SourcesByTopic stubs_;
  std::map<Key, Slot> slots_;
  std::vector<RelativePath> strays_;  ///< sources that no exercise wants
  std::vector<UnreadableFolder> unreadable_;
  std::vector<std::pair<std::string, std::string>> skipped_;  ///< name, or "" for anything, and why
  std::vector<std::string> notes_;
  /// (folder, reason) -> names ignored there
  std::map<std::pair<std::string, std::string>, std::vector<std::string>> ignored_;
  std::map<std::string, std::set<std::uint64_t>> contracts_;  ///< as in Submission
  std::size_t seen_ = 0;
  std::size_t handedOut_ = 0;
  std::size_t hidden_ = 0;
};

}  // namespace muelle::grader
