#pragma once
#include "grader/intake/intake.h"

#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace muelle::grader {

/// A path inside a submission, split at "/"; no empty, "." or ".." components. Untrusted bytes.
using RelativePath = std::vector<std::string>;

/// "spring_1d/spring_1d.cpp", printable and cut.
std::string show(const RelativePath& path);

/// What reading a file gave: its text, or the reason why it is refused.
struct Content {
  std::string text;
  std::string refusal;  ///< "is larger than 256 KiB"; "" when it was read
};

/// Chooses, among all that a submission holds, the files that count. TOPIC/FILE goes before a flat FILE, then the
/// shallower place; two of the same rank are refused, for nobody can tell which one was meant.
class Collector {
 public:
  Collector(const std::vector<Manifest>& course, IntakeLimits limits);

  const IntakeLimits& limits() const { return limits_; }

  /// A regular file; `read` is called only when its content may count.
  void file(const RelativePath& path, const std::function<Content()>& read);

  /// Something else with a name: `why` completes "spring_1d.cpp ...": "is a symbolic link". Refused where a file is
  /// wanted, ignored elsewhere.
  void notAFile(const RelativePath& path, const std::string& why);

  /// Anything that is ignored for a reason of its own; `what` is a printable line.
  void note(const std::string& what);

  /// True for folders that never hold a hand-in: hidden ones and the Mac's resource forks.
  static bool isSkipped(const std::string& component);

  Submission finish(std::string name) const;

 private:
  struct Slot {
    std::pair<int, std::size_t> rank;  ///< 0 in its place, 1 flat; then the depth
    std::vector<RelativePath> places;  ///< more than one: ambiguous
    Content content;
  };
  using Key = std::pair<std::string, std::string>;  ///< topic, file

  std::vector<Key> wantedBy(const RelativePath& path) const;
  void offer(const RelativePath& path, const std::function<Content()>& read);
  void ignore(const RelativePath& path, const std::string& why);
  /// Also counts it.
  bool isHidden(const RelativePath& path);
  bool isHandedOut(const RelativePath& path) const;
  bool isTopic(const std::string& name) const;
  std::string misnamed(const std::string& name) const;
  std::vector<std::string> notes() const;

  const std::vector<Manifest>& course_;
  IntakeLimits limits_;
  std::map<Key, Slot> slots_;
  std::vector<std::string> notes_;
  /// (folder, reason) -> names ignored there
  std::map<std::pair<std::string, std::string>, std::vector<std::string>> ignored_;
  std::size_t handedOut_ = 0;
  std::size_t hidden_ = 0;
};

}  // namespace muelle::grader
