#include "base/text/lists.h"
#include "course/check/exercise_check.h"
#include "course/check/public_parts.h"
#include "grader/authoring/lint.h"

#include <fmt/format.h>
#include <algorithm>

namespace muelle::grader {

namespace {

/// The files of the manifest in a folder of the checkout, through the public tests.
TestReport checked(const Workplace& workplace, const Manifest& manifest, const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> sources;
  for (const std::string& name : manifest.files) sources.push_back(workplace.source / folder / name);
  const CheckFolders folders{workplace.exercises(), workplace.binary, workplace.source / "out"};
  const StudentProgram program = buildStudentProgram(manifest, sources, folders);
  if (!program.executable.empty()) return runPublicTests(program);
  TestReport report;
  report.crash = program.message;
  return report;
}

/// "Suite.Name", or why no test ran.
std::string firstFailure(const TestReport& report) {
  if (!report.crash.empty()) return report.crash;
  if (report.failures.empty()) return "no test ran";
  return fmt::format("{}.{}", report.failures.front().suite, report.failures.front().name);
}

class RowLint {
 public:
  explicit RowLint(const TopicMatrix& matrix) : matrix_(matrix) {}

  std::vector<Finding> lint() {
    for (const MatrixRow& row : matrix_.rows) lintRow(row);
    const std::string contract = fmt::format("exercises/{0}/{0}.h", matrix_.manifest.topic);
    for (const std::string& line : matrix_.endsNotPassed)
      add(contract, line, "pass it in the hidden tests, or narrow the range");
    for (const std::string& line : matrix_.mistakesNotToldApart) {
      add(fmt::format("tests/hidden/{}/mistakes.cpp", matrix_.manifest.topic), line, "");
    }
    for (const std::string& line : matrix_.staleSurvivors) {
      add(fmt::format("tests/submissions/{}/mutants.toml", matrix_.manifest.topic), line, "take the entry out");
    }
    return std::move(findings_);
  }

 private:
  void lintRow(const MatrixRow& row) {
    if (row.exact()) return;
    if (!row.trouble.empty()) return add(row.file, row.trouble, "mend it");
    const std::string lost = row.lost.empty() ? "nothing" : joined(row.lost, ", ");
    if (row.kind == MatrixRow::Kind::Stub) {
      return add(row.file, fmt::format("the stub earns {:g} points in the hidden tests", row.points),
                 "make it return zeros, or the tests ask for more");
    }
    if (row.kind == MatrixRow::Kind::Wrong) {
      const std::string named = row.named.empty() ? "none" : joined(row.named, ", ");
      return add(row.file, fmt::format("loses {} and is named {}, otherwise than stated", lost, named),
                 "mend the hidden tests or its first line");
    }
    const char* who = row.kind == MatrixRow::Kind::Solution ? "the solution" : "a right submission";
    add(row.file, fmt::format("{} loses {}", who, lost), "mend it or the hidden tests");
  }

  void add(std::string where, std::string what, std::string todo) {
    findings_.push_back({std::move(where), std::move(what), std::move(todo)});
  }

  const TopicMatrix& matrix_;
  std::vector<Finding> findings_;
};

}  // namespace

std::vector<Finding> lintPublicTests(const Workplace& workplace, const Manifest& manifest) {
  buildPublicParts(workplace.binary, manifest.topic);
  std::vector<Finding> findings;
  const std::string& name = manifest.files.front();
  if (checked(workplace, manifest, std::filesystem::path("exercises") / manifest.topic).allPassed()) {
    findings.push_back({fmt::format("exercises/{}/{}", manifest.topic, name), "the stub passes the public tests",
                        "add a test that it fails"});
  }
  const TestReport solution = checked(workplace, manifest, std::filesystem::path("solutions") / manifest.topic);
  if (!solution.allPassed()) {
    findings.push_back({fmt::format("solutions/{}/{}", manifest.topic, name),
                        fmt::format("the solution fails in public: {}", firstFailure(solution)),
                        fmt::format("./muelle check {0} --file solutions/{0}/{1}", manifest.topic, name)});
  }
  return findings;
}

std::vector<Finding> lintGraded(const TopicMatrix& matrix) { return RowLint(matrix).lint(); }

}  // namespace muelle::grader
