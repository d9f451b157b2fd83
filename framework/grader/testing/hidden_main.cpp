/// \file
/// The main of every hidden test program: grades one criterion and writes its record, or draws the demo's curves.
/// No code of a student is ever loaded here; submission::f is a call to a worker.

#include "base/command_line.h"
#include "base/file.h"
#include "course/suites.h"
#include "course/testing/demo_binding.h"
#include "course/testing/random.h"
#include "figures/write.h"
#include "grader/record.h"
#include "grader/remote/core_pin.h"
#include "grader/remote/fault.h"
#include "grader/remote/own_lower.h"
#include "grader/sandbox/sandbox.h"
#include "grader/testing/asked_afresh.h"
#include "grader/testing/gather_evidence.h"
#include "grader/testing/listed_mistakes.h"
#include "grader/testing/of_use.h"
#include "grader/testing/recorder.h"
#include "grader/testing/seen.h"
#include "grader/testing/shrink.h"
#include "grader/testing/wrong_answers.h"

#include <fmt/format.h>
#include <filesystem>
#include <iostream>
#include <set>

std::vector<muelle::Figure> muelleDemo();

namespace {

using namespace muelle::grader;
using muelle::Outcome;

struct Options {
  std::string topic;
  std::string suite;
  std::string worker;
  std::string host;
  std::string record;
  std::string figures;
  std::string coreLocks;
  std::string sandbox = "auto";
  std::uint64_t seed = 0;
  int wallMilliseconds = 30'000;
  int callSeconds = muelle::usualCallSeconds;
  bool sanitised = false;
  bool refilled = false;
  bool forAuthors = false;            ///< the record holds what authors compare, too
  std::string contract;               ///< the header, for names and ranges
  std::vector<std::string> ownLower;  ///< given::f of these is the student's f
};

/// For the tests of the course: the suites of this program and the mistakes that it can name.
int list() {
  const ::testing::UnitTest& tests = *::testing::UnitTest::GetInstance();
  for (int i = 0; i < tests.total_test_suite_count(); ++i) {
    std::cout << "suite " << tests.GetTestSuite(i)->name() << '\n';
  }
  for (const auto& [function, history] : CallHistoryBase::all()) {
    for (const std::string& id : history->mistakes()) std::cout << "mistake " << function << ' ' << id << '\n';
  }
  for (const auto& [function, id] : mistakesToBeSeen()) std::cout << "mistake " << function << ' ' << id << '\n';
  return 0;
}

/// The suites of this program, and how many of their tests run.
std::vector<muelle::TestSuite> ownSuites() {
  const ::testing::UnitTest& tests = *::testing::UnitTest::GetInstance();
  std::vector<muelle::TestSuite> suites;
  for (int i = 0; i < tests.total_test_suite_count(); ++i) {
    const ::testing::TestSuite& suite = *tests.GetTestSuite(i);
    for (int j = 0; j < suite.total_test_count(); ++j) {
      muelle::countTest(suites, suite.name(), suite.GetTestInfo(j)->name());
    }
  }
  return suites;
}

/// For the build: says where manifest and tests disagree. The files are the manifest, the source of this program, the
/// public tests, as the author knows them: relative to the checkout, in which this program is started
int agree(const std::string& manifestFile, const std::string& hiddenSource, const std::string& publicSource) {
  const muelle::Manifest manifest = muelle::readManifest(manifestFile);
  std::vector<std::string> lines = muelle::disagreements(manifest, ownSuites(), manifestFile, hiddenSource);
  const auto ofPublic = muelle::publicDisagreements(manifest, muelle::suitesInSource(muelle::readFile(publicSource)),
                                                    manifestFile, publicSource);
  lines.insert(lines.end(), ofPublic.begin(), ofPublic.end());
  const auto ofFollows = withoutArguments(manifest, manifestFile);
  lines.insert(lines.end(), ofFollows.begin(), ofFollows.end());
  for (const std::string& line : lines) std::cerr << line << '\n';
  return lines.empty() ? 0 : 1;
}

Options readOptions(int argc, char** argv) {
  Options options;
  muelle::CommandLine program("", "Grades one criterion of an exercise; started by the grader.");
  program.option("--topic", options.topic, "").required();
  program.option("--suite", options.suite, "");
  program.option("--worker", options.worker, "").required();
  program.option("--host", options.host, "").required();
  program.option("--record", options.record, "");
  program.option("--figures", options.figures, "");
  program.option("--core-locks", options.coreLocks, "").required();
  program.option("--sandbox", options.sandbox, "");
  program.option("--wall-milliseconds", options.wallMilliseconds, "");
  program.option("--call-seconds", options.callSeconds, "");
  program.flag("--sanitised", options.sanitised, "");
  program.flag("--refilled", options.refilled, "");
  program.flag("--for-authors", options.forAuthors, "");
  program.option("--contract", options.contract, "");
  program.option("--own-lower", options.ownLower, "").separator(',');
  program.option("--seed", options.seed, "").required();
  program.run(argc, argv);
  return options;
}

/// given::f becomes the student's f where that is of use. The first entry of the record is about it: passed when there
/// is such a function; its property names those that what is built on them may be judged without.
void useOwnLower(const Options& options, Verdict& verdict) {
  std::set<std::string> ownLower;
  TestOutcome outcome;
  outcome.name = "LowerFunctionsAreOfUse";
  for (const std::string& function : options.ownLower) {
    const Use use = useToOthers(function, options.seed);
    if (use == Use::Good) ownLower.insert(function);
    if (use != Use::None) outcome.property += (outcome.property.empty() ? "" : ",") + function;
  }
  outcome.passed = !ownLower.empty();
  verdict.tests.push_back(outcome);
  setOwnLower(std::move(ownLower));
}

void grade(const Options& options, Session& session, Verdict& verdict) {
  ::testing::GTEST_FLAG(filter) = options.suite + ".*";
  auto& listeners = ::testing::UnitTest::GetInstance()->listeners();
  delete listeners.Release(listeners.default_result_printer());
  listeners.Append(new Recorder(session, verdict));  // GoogleTest owns its listeners
  if (!options.ownLower.empty()) {
    useOwnLower(options, verdict);
  }
  const bool isWorthwhile = verdict.tests.empty() || verdict.tests.front().passed;
  [[maybe_unused]] const int unused = isWorthwhile ? RUN_ALL_TESTS() : 0;
  verdict.fault = session.fault();
  verdict.isConfirmed = session.isConfirmed();
  verdict.graderFault = session.graderFault();
  verdict.timedOut = session.timedOutFunction();
}

/// What the calls came to: the session's word when something went wrong, else the tests'.
Outcome outcomeOf(const Verdict& verdict, const Session& session) {
  if (!session.fault().empty()) return session.outcome();
  const bool allPassed =
      std::all_of(verdict.tests.begin(), verdict.tests.end(), [](const TestOutcome& test) { return test.passed; });
  if (allPassed) return Outcome::Passed;
  return session.neverWritten().empty() ? Outcome::Wrong : Outcome::NeverWritten;
}

/// What the calls say, for the pool: it sees all criteria. Of memory that was never written the numbers are nobody's: a
/// NaN of the fill is no missing guard.
Evidence evidenceOf(const Verdict& verdict, const Session& session, bool forAuthors) {
  Evidence evidence;
  for (const auto& [function, history] : CallHistoryBase::all()) {
    if (function == verdict.neverWritten) continue;
    FunctionEvidence found = gatherEvidence(*history);
    if (verdict.outcome == Outcome::Wrong)
      found.isStateful = session.unreliable().contains(function) || answersOtherwiseAfresh(function, *history, found);
    if (forAuthors && found.wrong > 0) found.answers = sampleOfWrongAnswers(*history);
    if (forAuthors && verdict.outcome == Outcome::Passed) found.listed = listedMistakes(*history);
    if (found.calls > 0) evidence.emplace(function, std::move(found));
  }
  return evidence;
}

/// One of each function that has answered wrongly, but not of one that answers the same call otherwise when it is asked
/// on paper. A fault that only the search meets costs nothing: the verdict is made.
std::vector<CounterExample> examplesOf(const Verdict& verdict, const std::string& contract) {
  std::vector<CounterExample> examples;
  if (verdict.outcome != Outcome::Wrong || contract.empty()) return examples;
  const std::string text = muelle::readFile(contract);
  for (const auto& [function, history] : CallHistoryBase::all()) {
    const auto found = verdict.evidence.find(function);
    if (found != verdict.evidence.end() && found->second.isStateful) continue;
    try {
      if (auto example = simplestCounterExample(function, *history, text)) examples.push_back(std::move(*example));
    } catch (const SubmissionFault&) {
      break;
    }
  }
  return examples;
}

void drawFigures(const Options& options) {
  muelle::setDemoOf(muelle::DemoOf::Oracle);
  const std::vector<muelle::Figure> reference = muelleDemo();
  muelle::setDemoOf(muelle::DemoOf::Submission);
  const std::vector<muelle::Figure> student = muelleDemo();
  std::vector<muelle::Figure> figures;
  for (std::size_t i = 0; i < student.size(); ++i) {
    figures.push_back(i < reference.size() ? student[i].over(reference[i]) : student[i]);
  }
  muelle::writeFigures(figures, options.figures);
}

int run(int argc, char** argv) {
  const Options options = readOptions(argc, argv);
  const CorePin pin(options.coreLocks);
  const auto sandbox = settledSandbox(parseSandboxChoice(options.sandbox));
  SessionLimits limits;
  limits.callWall = limits.loadWall = limits.startWall = std::chrono::milliseconds(options.wallMilliseconds);
  limits = limits.forCallsOf(options.callSeconds);
  if (options.sanitised) limits = limits.forSanitised();
  Session session(
      {sandbox.get(), options.host, options.worker, options.seed, limits, options.sanitised, options.refilled});
  Session::setCurrent(&session);
  muelle::setTestSeed(options.seed);

  Verdict verdict;
  verdict.topic = options.topic;
  verdict.suite = options.suite.empty() ? "curves" : options.suite;
  const auto start = std::chrono::steady_clock::now();
  if (options.figures.empty()) {
    grade(options, session, verdict);
    verdict.outcome = outcomeOf(verdict, session);
    verdict.neverWritten = session.neverWritten();
    if (options.ownLower.empty()) {
      verdict.evidence = evidenceOf(verdict, session, options.forAuthors);
      verdict.examples = examplesOf(verdict, options.contract);
    }
  } else {
    try {
      drawFigures(options);
    } catch (const SubmissionFault& fault) {
      verdict.fault = fault.what();
    }
    verdict.outcome = session.fault().empty() ? Outcome::Passed : session.outcome();
    verdict.graderFault = session.graderFault();
  }
  verdict.output = session.output();
  verdict.calls = session.calls();
  verdict.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  writeRecord(verdict, options.record);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  int quiet = 1;  // our own options are not GoogleTest's
  ::testing::InitGoogleTest(&quiet, argv);
  try {
    if (argc == 2 && std::string_view(argv[1]) == "--list") return list();
    if (argc == 5 && std::string_view(argv[1]) == "--agree") return agree(argv[2], argv[3], argv[4]);
    return run(argc, argv);
  } catch (const std::exception& error) {
    std::cerr << "muelle: " << error.what() << '\n';
    return 1;
  }
}
