#pragma once
#include "grader/intake/intake.h"

#include <cstdint>
#include <functional>
#include <map>
#include <set>
#include <string>
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

/// Chooses, among all that a submission holds, the files that count. The exact name goes before a near one, TOPIC/FILE
/// before a flat FILE, then the shallower place. Of the same rank, equal contents count once; where they differ none
/// counts, for nobody can tell which one was meant.
class Collector {
 public:
  /// `only`: the topics asked for; all when empty. `course` must outlive this.
  Collector(const std::vector<Manifest>& course, IntakeLimits limits, std::vector<std::string> only = {});

  const IntakeLimits& limits() const { return limits_; }

  /// A regular file; `read` is called only when its content may count.
  void file(const RelativePath& path, const std::function<Content()>& read);

  /// Something else with a name: `why` completes "spring_1d.cpp ...": "is a symbolic link". Refused where a file is
  /// wanted, ignored elsewhere.
  void notAFile(const RelativePath& path, const std::string& why);

  /// A folder that this machine cannot look into: whatever it may hold is unknown. `why` as in Content::fault.
  void unreadableFolder(const RelativePath& path, const std::string& why);

  /// An archive inside that could not be read to its end; `why` is a whole line. Ends the taking when a topic lacks a
  /// file (finish() throws), since it may be in there.
  void brokenArchive(const std::string& why);

  /// Anything that is ignored for a reason of its own; `what` is a printable line.
  void note(const std::string& what);

  /// True for folders that never hold a hand-in: hidden ones and the Mac's resource forks.
  static bool isSkipped(const std::string& component);

  /// Throws std::runtime_error with the reason of the first broken archive when a topic lacks a file.
  Submission finish(std::string name) const;

 private:
  /// 0 the exact name, 1 a near one; 0 in its folder, 1 flat; then the depth.
  using Rank = std::tuple<int, int, std::size_t>;
  struct Slot {
    Rank rank;
    std::vector<RelativePath> places;
    Content content;            ///< of the first place, as text
    std::string note{};         ///< what reading it changed
    bool differ = false;        ///< another place of the rank holds something else
    std::size_t different = 0;  ///< the first place that does
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
  void add(Slot& slot, const RelativePath& path, Content content) const;
  void ignore(const RelativePath& path, const std::string& why);
  /// Also counts it.
  bool isHidden(const RelativePath& path);
  bool isHandedOut(const RelativePath& path) const;
  /// Counts it, and keeps what a contract's text comes to.
  void handedOut(const RelativePath& path, const std::function<Content()>& read);

  void settle(const Key& key, const Slot& slot, Submission& submission) const;
  void say(const Manifest& manifest, Submission& submission) const;
  std::string missing(const std::string& topic, const std::string& file) const;
  std::vector<std::string> near(const std::string& topic, const std::string& file) const;
  const UnreadableFolder* mayHide(const std::string& topic, const std::string& file) const;
  std::size_t unfound() const;
  std::vector<std::string> notes(const Submission& submission) const;

  const std::vector<Manifest>& course_;
  IntakeLimits limits_;
  std::vector<std::string> only_;
  std::map<Key, Slot> slots_;
  std::vector<RelativePath> strays_;  ///< sources that no exercise wants
  std::vector<UnreadableFolder> unreadable_;
  std::vector<std::string> broken_;
  std::vector<std::string> notes_;
  /// (folder, reason) -> names ignored there
  std::map<std::pair<std::string, std::string>, std::vector<std::string>> ignored_;
  std::map<std::string, std::set<std::uint64_t>> contracts_;  ///< as in Submission
  std::size_t seen_ = 0;
  std::size_t handedOut_ = 0;
  std::size_t hidden_ = 0;
};

}  // namespace muelle::grader
