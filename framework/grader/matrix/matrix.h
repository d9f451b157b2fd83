#pragma once
#include "grader/authors/grade_again.h"
#include "grader/matrix/expectation.h"
#include "grader/matrix/survivors.h"
#include "grader/run/keys.h"

#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace muelle::grader {

/// One seed for all runs of the tests of the tests, so that a row is the same today and tomorrow.
inline constexpr const char* usualSeed = "tests of the tests";

/// How the tests of the tests are run.
struct MatrixOptions {
  GradeOptions grading;
  bool mutants = true;
  int share = 1;  ///< grade one known submission and one mutant in so many; new, changed and listed ones always
  int jobs = 2;
};

/// One submission whose outcome is known beforehand.
struct MatrixRow {
  enum class Kind { Solution, Stub, Right, Wrong };
  Kind kind = Kind::Wrong;
  std::string name;  ///< the folder's: "wrong_sign"
  std::string file;  ///< for messages: "tests/submissions/spring_1d/wrong/wrong_sign/spring_1d.cpp"
  Sources sources;
  Expectation expected;

  std::set<std::string> lost;   ///< suites that did not pass
  std::set<std::string> named;  ///< misconceptions that were named, over all criteria
  int examples = 0;             ///< criteria that show a call, and of these
  int examplesForPaper = 0;     ///< those whose first has numbers of two digits at most
  double points = 0.0;
  std::string trouble;  ///< does not compile, a fault of the grader's: one line; "" when it was graded

  bool exact() const;
  /// Whether one of the stated mistakes was named, or none where none is stated, and nothing else.
  bool isNamedAsStated() const;
};

/// One mutation of the solution and what became of it.
struct Mutant {
  enum class Fate { Killed, NotCompilable, Survived };
  Mutation mutation;
  Fate fate = Fate::Survived;
  std::string killer;   ///< the suite that failed first
  std::string reason;   ///< of mutants.toml; "" when it is not listed
  std::string excuse;   ///< of mutants.toml for any that survives; "" when there is none
  std::string trouble;  ///< a fault of the grader's; "" when it was graded

  /// Why it may survive; "" when nothing says so.
  const std::string& whySurvives() const { return reason.empty() ? excuse : reason; }
  /// Killed and not listed, or survived with a reason.
  bool asStated() const;
};

/// The tests of one exercise's hidden tests.
struct TopicMatrix {
  Manifest manifest;
  std::vector<MatrixRow> rows;
  std::vector<Mutant> mutants;
  std::set<std::string> sentences;                ///< what students are told, without its numbers
  std::vector<std::string> endsNotPassed;         ///< of the contract's ranges, one line each
  std::vector<std::string> mistakesNotToldApart;  ///< of those that the exercise lists, one line each
  std::vector<UnnamedHandIn> unnamed;             ///< wrong submissions that lose a criterion without a name
  std::vector<std::string> staleSurvivors;        ///< entries of mutants.toml that match no mutation, one line each

  bool good() const;
};

/// Counts over all topics.
struct MatrixSummary {
  int rows = 0;
  int exactRows = 0;
  int falseRejections = 0;   ///< right submissions, solution included, that lost something
  int misconceptions = 0;    ///< rows that state one
  int named = 0;             ///< of these, where it was named
  int wronglyNamed = 0;      ///< names, in all rows, of something else than is stated
  int examples = 0;          ///< criteria, in all rows, that show a call
  int examplesForPaper = 0;  ///< of these, where the numbers of the first have two digits at most
  int killed = 0;
  int notCompilable = 0;
  int survivedWithReason = 0;
  int survivedWithout = 0;
  int staleSurvivors = 0;  ///< listed, and killed, not compilable or gone
  int troubles = 0;        ///< the grader's own faults
};

MatrixSummary summarise(const std::vector<TopicMatrix>& matrices);

/// Reads what is to be graded of one exercise: solution, stub, tests/submissions/TOPIC and the solution's mutations.
/// Throws std::runtime_error with file and line when a first line or mutants.toml cannot be understood, and when the
/// hidden tests are not built.
TopicMatrix planMatrix(const Workplace& workplace, const Manifest& manifest, const MatrixOptions& options);

/// Called as submissions are graded, from one thread at a time. \param fraction done, from 0 to 1
using MatrixListener = std::function<void(double fraction)>;

/// Grades everything planned, `options.jobs` at a time. Verdicts are kept in the build folder as those of any grading.
/// The solution is graded for authors, so that its calls tell the listed mistakes apart.
void runMatrix(const Workplace& workplace, std::vector<TopicMatrix>& matrices, const MatrixOptions& options,
               const MatrixListener& progress = {});

}  // namespace muelle::grader
