#include "grader/authoring/lint.h"

#include "base/file.h"
#include "base/text/count.h"
#include "base/text/trim.h"
#include "course/contract.h"
#include "course/suites.h"
#include "grader/authoring/lint_contract.h"
#include "grader/authoring/scaffold.h"
#include "grader/matrix/corpus_share.h"

#include <fmt/format.h>
#include <algorithm>
#include <optional>
#include <set>
#include <sstream>

namespace muelle::grader {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t fewestCriteria = 5;
constexpr std::size_t mostCriteria = 15;
constexpr std::size_t fewestRight = 2;
constexpr std::size_t fewestWrong = 8;

/// Those that every exercise has: they lose everything, whatever its functions are.
const std::set<std::string> plainWrongs = {"zero", "constant", "stateful"};

/// \param error of readManifest(): "TOPIC/exercise.toml:LINE: what is wrong"
Finding unreadable(const std::string& topic, const std::string& error, const std::string& todo) {
  const std::size_t colon = error.starts_with(topic + "/") ? error.find(": ") : std::string::npos;
  if (colon == std::string::npos) return {fmt::format("exercises/{}/exercise.toml", topic), error, todo};
  return {"exercises/" + error.substr(0, colon), error.substr(colon + 2), todo};
}

/// One exercise's four folders.
class FileLint {
 public:
  FileLint(fs::path checkout, std::string topic) : checkout_(std::move(checkout)), topic_(std::move(topic)) {}

  std::vector<Finding> lint() {
    lintPresence();
    lintMarks();
    lintStatement();
    if (exists(contract())) {
      for (Finding& finding : lintContract(read(contract()), contract())) findings_.push_back(std::move(finding));
    }
    if (const auto manifest = readIt()) {
      lintCriteria(*manifest);
      lintPublicSuites(*manifest);
      lintSubmissions(*manifest);
    }
    return std::move(findings_);
  }

 private:
  std::string exercise(const std::string& name) const { return fmt::format("exercises/{}/{}", topic_, name); }
  std::string contract() const { return exercise(topic_ + ".h"); }
  std::string manifestName() const { return exercise("exercise.toml"); }
  std::string corpus() const { return "tests/submissions/" + topic_; }
  bool exists(const std::string& file) const { return fs::exists(checkout_ / file); }
  std::string read(const std::string& file) const { return readFile(checkout_ / file); }

  void add(std::string where, std::string what, std::string todo) {
    findings_.push_back({std::move(where), std::move(what), std::move(todo)});
  }

  /// The statement is one of these and is looked at below.
  void lintPresence() {
    for (const std::string& file :
         {contract(), exercise(topic_ + ".cpp"), exercise("public_test.cpp"), exercise("demo.cpp"), manifestName(),
          fmt::format("solutions/{0}/{0}.cpp", topic_), fmt::format("tests/hidden/{0}/{0}_test.cpp", topic_),
          fmt::format("tests/hidden/{}/oracle.cpp", topic_), fmt::format("tests/hidden/{}/mistakes.cpp", topic_)}) {
      if (!exists(file)) add(file, "is missing", "write it; docs/writing_an_exercise.md says how");
    }
  }

  void lintMarks() {
    for (const fs::path& folder : foldersOf(topic_)) {
      if (!fs::exists(checkout_ / folder)) continue;
      for (const auto& entry : fs::recursive_directory_iterator(checkout_ / folder)) {
        if (entry.is_regular_file()) lintMarksOf(entry.path().lexically_relative(checkout_).generic_string());
      }
    }
  }

  void lintMarksOf(const std::string& file) {
    std::istringstream lines(read(file));
    int number = 1;
    for (std::string line; std::getline(lines, line); ++number) {
      const std::size_t mark = line.find(writeMark);
      if (mark == std::string::npos) continue;
      std::string what(trimmed(line.substr(mark + std::string_view(writeMark).size())));
      what = std::string(trimmed(what.substr(0, std::min(what.find("-->"), what.find("](")))));  // of a page
      while (what.ends_with('.')) what.pop_back();
      add(fmt::format("{}:{}", file, number), "still to be written: " + what, "then take the mark out");
    }
  }

  void lintStatement() {
    const std::string statement = exercise("README.md");
    if (!exists(statement)) return add(statement, "is missing", "write the mathematics and what to do");
    if (!exists(exercise("figure.svg"))) {
      add(exercise("figure.svg"), "is missing: the statement has no figure", "draw one");
    } else if (read(statement).find("](figure.svg)") == std::string::npos) {
      add(statement, "does not show figure.svg", "add ![what it shows](figure.svg)");
    }
  }

  std::optional<Manifest> readIt() {
    if (!exists(manifestName())) return std::nullopt;
    try {
      return readManifest(checkout_ / manifestName());
    } catch (const std::exception& error) {
      findings_.push_back(unreadable(topic_, error.what(), "mend it: nothing else of this exercise can be looked at"));
      return std::nullopt;
    }
  }

  void lintCriteria(const Manifest& manifest) {
    const std::size_t count = manifest.criteria.size();
    if (count < fewestCriteria || count > mostCriteria) {
      add(manifestName(), counted(static_cast<long long>(count), "criterion", "criteria"),
          fmt::format("make it {} to {}", fewestCriteria, mostCriteria));
    }
    for (const Criterion& criterion : manifest.criteria) {
      lintWords(criterion.hint, fmt::format("criterion {} has an empty hint", criterion.suite));
      if (!(criterion.points > 0))
        add(manifestName(), fmt::format("criterion {} has no points", criterion.suite), "give it some");
      for (const std::string& function : criterion.functions) lintFunction(function, "criterion " + criterion.suite);
    }
    for (const Misconception& mistake : manifest.misconceptions) {
      lintWords(mistake.hint, fmt::format("misconception {} of {} has an empty hint", mistake.id, mistake.function));
      lintWords(mistake.says, fmt::format("misconception {} of {} says nothing", mistake.id, mistake.function));
      lintFunction(mistake.function, "misconception " + mistake.id);
    }
  }

  void lintWords(const std::string& words, const std::string& what) {
    if (trimmed(words).empty()) add(manifestName(), what, "one sentence on where to look");
  }

  void lintFunction(const std::string& function, const std::string& of) {
    if (!exists(contract())) return;
    const std::vector<std::string> functions = functionsOf(read(contract()));
    if (std::ranges::find(functions, function) != functions.end()) return;
    add(manifestName(), fmt::format("{} names {}, which the contract does not have", of, function),
        "take a name of its MUELLE_FUNCTIONS");
  }

  void lintPublicSuites(const Manifest& manifest) {
    const std::string tests = exercise("public_test.cpp");
    if (!exists(tests)) return;
    const std::vector<TestSuite> suites = suitesInSource(read(tests));
    for (const std::string& line : publicDisagreements(manifest, suites, manifestName(), tests)) {
      add(tests, line, "make them agree");
    }
    if (suites.size() < 2) add(tests, "one suite only", "test a second criterion with numbers checked by hand");
  }

  void lintSubmissions(const Manifest& manifest) {
    const std::vector<fs::path> right = foldersIn(checkout_ / corpus() / "right");
    const std::vector<fs::path> wrong = foldersIn(checkout_ / corpus() / "wrong");
    lintCount(corpus() + "/right", right.size(), fewestRight, "of other styles, each with full marks");
    lintCount(corpus() + "/wrong", wrong.size(), fewestWrong, "of one plausible mistake each");
    for (const std::string& name : plainWrongs) {
      if (!exists(corpus() + "/wrong/" + name))
        add(corpus() + "/wrong/" + name, "is missing", "it must lose everything");
    }
    lintWrong(manifest, wrong);
    lintKnown(right);
    lintKnown(wrong);
    if (!exists(corpus() + "/sentences.txt")) {
      add(corpus() + "/sentences.txt", "is missing: nobody has read what students are told", remember());
    }
  }

  void lintCount(const std::string& folder, std::size_t count, std::size_t fewest, const std::string& what) {
    if (count >= fewest) return;
    add(folder, counted(static_cast<long long>(count), "submission"),
        fmt::format("write {} at least, {}", fewest, what));
  }

  /// What the first lines state: which criteria are lost at all, and which mistakes are shown.
  void lintWrong(const Manifest& manifest, const std::vector<fs::path>& wrong) {
    std::set<std::string> lost, shown;
    for (const fs::path& folder : wrong) {
      const fs::path file = folder / manifest.files.front();
      const std::string name = file.lexically_relative(checkout_).generic_string();
      if (!fs::exists(file)) {
        add(name, "is missing", "a submission has all files of exercise.toml");
        continue;
      }
      try {
        const Expectation stated = readExpectation(readFile(file), name, manifest);
        shown.insert(stated.named.begin(), stated.named.end());
        if (!plainWrongs.contains(folder.filename().string())) lost.insert(stated.lost.begin(), stated.lost.end());
      } catch (const std::exception& error) {
        const std::string what = error.what();  // begins with where
        add(name + ":1", what.substr(what.starts_with(name) ? what.find(": ") + 2 : 0), "mend it");
      }
    }
    for (const Criterion& criterion : manifest.criteria) {
      if (!lost.contains(criterion.suite)) {
        add(corpus() + "/wrong", fmt::format("no wrong submission loses {}", criterion.suite), "write one that does");
      }
    }
    std::set<std::string> told;
    for (const Misconception& mistake : manifest.misconceptions) {
      if (shown.contains(mistake.id) || !told.insert(mistake.id).second) continue;
      add(corpus() + "/wrong", fmt::format("no wrong submission shows {}", mistake.id), "write one that makes it");
    }
  }

  void lintKnown(const std::vector<fs::path>& folders) {
    const CorpusShare known(checkout_ / "tests/submissions", 1);
    for (const fs::path& folder : folders) {
      if (known.knows(folder)) continue;
      add(folder.lexically_relative(checkout_).generic_string(), "is not known to come out as stated", remember());
    }
  }

  std::string remember() const { return fmt::format("./muelle test-the-tests {} --remember", topic_); }

  fs::path checkout_;
  std::string topic_;
  std::vector<Finding> findings_;
};

}  // namespace

std::string Finding::text() const { return fmt::format("{}: {}{}{}", where, what, todo.empty() ? "" : "; ", todo); }

std::vector<Finding> lintManifests(const fs::path& checkout) {
  std::vector<Finding> findings;
  for (const auto& entry : fs::directory_iterator(checkout / "exercises")) {
    const fs::path manifest = entry.path() / "exercise.toml";
    if (!fs::exists(manifest)) continue;
    try {
      readManifest(manifest);
    } catch (const std::exception& error) {
      findings.push_back(unreadable(entry.path().filename().string(), error.what(),
                                    "mend it: nothing is built and graded until then"));
    }
  }
  std::ranges::sort(findings, {}, &Finding::where);
  if (!findings.empty()) return findings;
  try {
    readCourse(checkout / "exercises");
  } catch (const std::exception& error) {
    findings.push_back({"exercises", error.what(), ""});
  }
  return findings;
}

std::vector<Finding> lintFiles(const fs::path& checkout, const std::string& topic) {
  return FileLint(checkout, topic).lint();
}

}  // namespace muelle::grader
