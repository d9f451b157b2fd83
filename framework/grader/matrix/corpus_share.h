#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace muelle::grader {

/// One known submission in so many is taken by `./muelle test`; `./muelle test-the-tests` takes all.
inline constexpr int usualShare = 96;

/// Which submissions of a corpus (tests/submissions) are taken. A submission is known when the corpus's list
/// `known.txt` holds its folder with the digest of what stands in it now: all of it has once been seen to come out as
/// stated. Of the known ones a fixed share is taken, chosen by the names alone so that a new submission does not change
/// it; whatever is new or changed is always taken.
class CorpusShare {
 public:
  /// \param corpus holds the submissions, at any depth, and the list   \param every 1: takes everything
  /// Throws std::runtime_error naming the line that is not "DIGEST FOLDER".
  CorpusShare(std::filesystem::path corpus, int every);

  /// \param folder of one submission, within the corpus
  bool takes(const std::filesystem::path& folder) const;
  /// Whether the list holds the submission as it is now.
  bool knows(const std::filesystem::path& folder) const;

 private:
  std::filesystem::path corpus_;
  int every_;
  std::map<std::string, std::string> known_;  ///< folder relative to the corpus -> digest
};

/// The share that the environment variable MUELLE_SHARE asks for: "all", a number, or the usual one when it is not set.
/// Throws std::runtime_error when it is something else.
int shareOfEnvironment();

/// The folders that stand in `parent`, as those of a topic's wrong submissions, sorted; none where there is no parent.
std::vector<std::filesystem::path> foldersIn(const std::filesystem::path& parent);

/// The folders of the corpus that hold submissions (files and no folders), sorted.
std::vector<std::filesystem::path> submissionsIn(const std::filesystem::path& corpus);

/// Notes submissions of the corpus as known, in a file that replaces the old one whole: all of them, or those of
/// `topics` beside what is known of the others.
void rememberCorpus(const std::filesystem::path& corpus, const std::vector<std::string>& topics = {});

}  // namespace muelle::grader
