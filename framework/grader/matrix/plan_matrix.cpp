#include "base/file.h"
#include "course/check/source_text.h"
#include "grader/matrix/corpus_share.h"
#include "grader/matrix/matrix.h"
#include "grader/record.h"

#include <fmt/format.h>
#include <algorithm>
#include <stdexcept>

namespace muelle::grader {

namespace {

namespace fs = std::filesystem;

/// Reads the topics' files as one finds them in the checkout.
class Planner {
 public:
  Planner(const Workplace& workplace, const Manifest& manifest) : workplace_(workplace), manifest_(manifest) {}

  TopicMatrix plan(const MatrixOptions& options) {
    const fs::path program = workplace_.hiddenProgram(manifest_.topic);
    if (!fs::exists(program)) {
      throw std::runtime_error(
          fmt::format("the hidden tests of {} are not built ({} is missing): build the target hidden_{}",
                      manifest_.topic, shown(program), manifest_.topic));
    }
    if (!fs::exists(submissions())) {
      throw std::runtime_error(fmt::format("{} has no submissions to test its tests with: make {}/right and {}/wrong",
                                           manifest_.topic, shown(submissions()), shown(submissions())));
    }
    matrix_.manifest = manifest_;
    addRow(MatrixRow::Kind::Solution, "solution", solution());
    addRow(MatrixRow::Kind::Stub, "stub", workplace_.exercises() / manifest_.topic);
    const CorpusShare share(workplace_.source / "tests" / "submissions", options.share);
    addRows(MatrixRow::Kind::Right, "right", share);
    addRows(MatrixRow::Kind::Wrong, "wrong", share);
    if (options.mutants) addMutants(options.share);
    return std::move(matrix_);
  }

 private:
  fs::path submissions() const { return workplace_.source / "tests" / "submissions" / manifest_.topic; }
  fs::path solution() const { return workplace_.source / "solutions" / manifest_.topic; }
  std::string shown(const fs::path& path) const { return path.lexically_relative(workplace_.source).string(); }

  void addRows(MatrixRow::Kind kind, const std::string& side, const CorpusShare& share) {
    for (const fs::path& folder : foldersIn(submissions() / side)) {
      if (share.takes(folder)) addRow(kind, folder.filename().string(), folder);
    }
  }

  void addRow(MatrixRow::Kind kind, const std::string& name, const fs::path& folder) {
    MatrixRow row;
    row.kind = kind;
    row.name = name;
    for (const std::string& file : manifest_.files) {
      if (!fs::exists(folder / file)) throw std::runtime_error(fmt::format("{} is missing", shown(folder / file)));
      row.sources[file] = readSource(readFile(folder / file)).text;  // as intake would
    }
    const std::string& first = manifest_.files.front();
    row.file = shown(folder / first);
    if (kind == MatrixRow::Kind::Wrong) row.expected = readExpectation(row.sources.at(first), row.file, manifest_);
    if (kind == MatrixRow::Kind::Stub) row.expected = noPoints(manifest_);
    matrix_.rows.push_back(std::move(row));
  }

  void addMutants(int every) {
    const fs::path file = submissions() / "mutants.toml";
    auto [survivors, excuse] = readSurvivors(file, shown(file));
    const std::string& name = manifest_.files.front();
    int number = 0;
    for (const Mutation& mutation : mutations(readFile(solution() / name))) {
      Mutant mutant;
      mutant.mutation = mutation;
      mutant.excuse = excuse;
      const auto listed = std::find_if(survivors.begin(), survivors.end(),
                                       [&mutation](const Survivor& survivor) { return survivor.matches(mutation); });
      if (listed != survivors.end()) {
        mutant.reason = listed->reason;
        survivors.erase(listed);
      }
      if (number++ % every == 0 || !mutant.reason.empty()) matrix_.mutants.push_back(std::move(mutant));
    }
    for (const Survivor& survivor : survivors) {
      matrix_.staleSurvivors.push_back(fmt::format("{}: the solution has no mutation {} (occurrence {}) in a line '{}'",
                                                   shown(file), survivor.mutation, survivor.occurrence,
                                                   survivor.lineText));
    }
  }

  const Workplace& workplace_;
  const Manifest& manifest_;
  TopicMatrix matrix_;
};

}  // namespace

TopicMatrix planMatrix(const Workplace& workplace, const Manifest& manifest, const MatrixOptions& options) {
  return Planner(workplace, manifest).plan(options);
}

}  // namespace muelle::grader
