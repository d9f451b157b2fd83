#include "grader/run/judge.h"

#include "base/file.h"
#include "base/text/lists.h"
#include "course/check/fault_sentences.h"
#include "grader/record.h"
#include "grader/run/follow.h"

#include <fmt/format.h>
#include <algorithm>
#include <nlohmann/json.hpp>

namespace muelle::grader {

namespace {

namespace fs = std::filesystem;

constexpr const char* curvesSuite = "curves";
constexpr const char* recordSuffix = ".json";
constexpr const char* curvesSuffix = ".curves";

/// Which of the candidate's objects a test process loads.
enum class Look { First, Second, OtherFill };

std::vector<std::string> commandFor(const Workplace& workplace, const Candidate& candidate, const GradeOptions& options,
                                    Look look) {
  const bool isSecond = look == Look::Second;
  const fs::path& object = isSecond                  ? candidate.object.sanitised
                           : look == Look::OtherFill ? candidate.object.refilled
                                                     : candidate.object.plain;
  std::vector<std::string> command = {
      workplace.hiddenProgram(candidate.manifest.topic).string(),
      "--topic",
      candidate.manifest.topic,
      "--worker",
      object.string(),
      "--contract",
      workplace.contract(candidate.manifest.topic).string(),
      "--host",
      (isSecond ? workplace.sanitisedHost : workplace.host).string(),
      "--core-locks",
      workplace.coreLocks().string(),
      "--sandbox",
      toText(options.sandbox),
      "--wall-milliseconds",
      std::to_string(workplace.callWall.count()),
      "--call-seconds",
      std::to_string(candidate.manifest.callSeconds),
      "--seed",
      std::to_string(inputSeed(candidate.manifest, candidate.sources, options)),
  };
  if (isSecond) command.emplace_back("--sanitised");
  if (look == Look::OtherFill) command.emplace_back("--refilled");
  if (options.forAuthors) command.emplace_back("--for-authors");
  return command;
}

Verdict broken(const Candidate& candidate, const std::string& suite, const std::string& what) {
  Verdict verdict;
  verdict.topic = candidate.manifest.topic;
  verdict.suite = suite;
  verdict.graderFault = what;
  return verdict;
}

std::string howItEnded(const CommandResult& result) {
  if (result.timedOut) return "it took too long";
  return result.status.signalled ? fmt::format("signal {}", result.status.code)
                                 : fmt::format("exit {}", result.status.code);
}

/// Runs a hidden test program with a folder of its own; its record, or a verdict that says what is wrong with us.
Verdict runHiddenProgram(const Workplace& workplace, const Candidate& candidate, const std::string& suite,
                         std::vector<std::string> command, const fs::path& folder) {
  const fs::path file = folder / "record.json";
  command.insert(command.end(), {"--record", file.string()});
  ChildSpec spec;
  spec.command = std::move(command);
  spec.environment = {"PATH=/usr/bin:/bin", "LC_ALL=C.UTF-8"};
  Capture capture;
  capture.limit = workplace.criterionWall;
  const CommandResult result = runCommand(spec, capture);
  const std::optional<Verdict> verdict = readRecord(file);
  if (verdict && verdict->topic == candidate.manifest.topic && verdict->suite == suite) return *verdict;
  return broken(candidate, suite,
                fmt::format("the test program of {} left no record ({}): {}", candidate.manifest.topic,
                            howItEnded(result), result.err.substr(0, 500)));
}

/// What is judged, and how.
struct Judging {
  const Workplace& workplace;
  const Candidate& candidate;
  const Criterion& criterion;
  const GradeOptions& options;
  const std::vector<std::string>& ownLower;
};

Verdict judgeOnce(const Judging& judging, Look look) {
  const auto& [workplace, candidate, criterion, options, ownLower] = judging;
  try {
    const TemporaryFolder folder(workplace.work());
    std::vector<std::string> command = commandFor(workplace, candidate, options, look);
    command.insert(command.end(), {"--suite", criterion.suite});
    if (!ownLower.empty()) command.insert(command.end(), {"--own-lower", joined(ownLower, ",")});
    return runHiddenProgram(workplace, candidate, criterion.suite, std::move(command), folder.path());
  } catch (const std::exception& error) {
    return broken(candidate, criterion.suite, error.what());
  }
}

/// The first of two looks, unless the sanitizers confirm a misuse of memory in the second. Nothing else of that costs
/// points: processor time, stack and memory are dearer there, so that right code may run out of them.
Verdict withSecondLook(const Judging& judging, Verdict first) {
  if (judging.candidate.object.sanitised.empty() || isDoubtful(first)) return first;
  const Verdict second = judgeOnce(judging, Look::Second);
  const bool isMachines = isDoubtful(second) && second.outcome != Outcome::Cpu;
  return second.isConfirmed || isMachines ? second : first;
}

/// The call of the first test that failed in one look and passed in the other, "" when it is not known; nullopt when
/// there is none. What ended the calls of one look ended them for all tests: then both are compared as a whole.
std::optional<std::string> luckyCall(const Verdict& one, const Verdict& other) {
  const auto failure = [](const Verdict& verdict) {
    const auto test = std::ranges::find(verdict.tests, false, &TestOutcome::passed);
    return test == verdict.tests.end() ? "" : test->call;
  };
  if (one.passed() != other.passed()) return failure(one.passed() ? other : one);
  if (!one.fault.empty() || !other.fault.empty()) return std::nullopt;
  for (const TestOutcome& test : one.tests) {
    const auto same = std::ranges::find(other.tests, test.name, &TestOutcome::name);
    if (same != other.tests.end() && same->passed != test.passed) return test.passed ? same->call : test.call;
  }
  return std::nullopt;
}

/// Where a test passes with one fill of what was never written and fails with the other, it depends on that, and has
/// passed by luck.
Verdict withOtherFill(const Judging& judging, Verdict first) {
  const bool isKnown = first.outcome == Outcome::NeverWritten;
  if (judging.candidate.object.refilled.empty() || isKnown || isDoubtful(first)) return first;
  const Verdict second = judgeOnce(judging, Look::OtherFill);
  if (isDoubtful(second)) return second.outcome == Outcome::Cpu ? first : second;
  const std::optional<std::string> call = luckyCall(first, second);
  if (!call) return first;
  const std::string function = call->substr(0, call->find('('));
  first.outcome = Outcome::NeverWritten;
  first.fault = fmt::format("{} {}", function.empty() ? "your code" : function, luckSentence);
  first.neverWritten.clear();
  first.evidence.clear();
  return first;
}

std::vector<std::string> readSvgs(const fs::path& folder) {
  std::vector<fs::path> files;
  if (fs::exists(folder)) {
    for (const auto& entry : fs::directory_iterator(folder)) {
      if (entry.path().extension() == ".svg") files.push_back(entry.path());
    }
  }
  std::sort(files.begin(), files.end());
  std::vector<std::string> svgs;
  for (const fs::path& file : files) svgs.push_back(readFile(file));
  return svgs;
}

std::string toText(const Curves& curves) {
  return nlohmann::json{{"note", curves.note}, {"svgs", curves.svgs}}.dump(-1, ' ', false,
                                                                           nlohmann::json::error_handler_t::replace);
}

}  // namespace

bool isDoubtful(const Verdict& verdict) {
  return !verdict.graderFault.empty() || verdict.outcome == Outcome::Killed || verdict.outcome == Outcome::Wall ||
         isOwnIfTwice(verdict);
}

bool isOwnIfTwice(const Verdict& verdict) {
  return verdict.graderFault.empty() && (verdict.outcome == Outcome::Cpu || verdict.outcome == Outcome::Struck);
}

std::optional<Verdict> keptVerdict(const Workplace& workplace, const Store& store, const Candidate& candidate,
                                   const Criterion& criterion, const GradeOptions& options) {
  try {
    const std::string key = verdictKey(workplace, candidate.manifest, criterion, candidate.objectKey, options);
    const std::optional<Verdict> verdict = readRecord(store.file(key, recordSuffix));
    const bool belongs = verdict && verdict->topic == candidate.manifest.topic && verdict->suite == criterion.suite;
    return belongs ? verdict : std::nullopt;
  } catch (const std::exception&) {  // a program that this machine cannot read: judging says so
    return std::nullopt;
  }
}

void keepVerdict(const Workplace& workplace, const Store& store, const Candidate& candidate, const Criterion& criterion,
                 const GradeOptions& options, const Verdict& verdict) {
  const std::string key = verdictKey(workplace, candidate.manifest, criterion, candidate.objectKey, options);
  const fs::path file = store.file(key, recordSuffix);
  fs::create_directories(file.parent_path());
  writeRecord(verdict, file);
}

Verdict lookAtCriterion(const Workplace& workplace, const Candidate& candidate, const Criterion& criterion,
                        const GradeOptions& options, const std::vector<std::string>& ownLower) {
  const Judging judging{workplace, candidate, criterion, options, ownLower};
  return withSecondLook(judging, withOtherFill(judging, judgeOnce(judging, Look::First)));
}

Verdict judgeCriterion(const JudgingPlace& place, const Candidate& candidate, const Criterion& criterion,
                       const GradeOptions& options) {
  const Verdict asItIs = lookAtCriterion(place.workplace, candidate, criterion, options, {});
  if (isDoubtful(asItIs)) return asItIs;
  Verdict verdict = followLower(place, candidate, criterion, options, asItIs);
  if (isDoubtful(verdict)) return verdict;
  try {
    keepVerdict(place.workplace, place.records, candidate, criterion, options, verdict);
    return verdict;
  } catch (const std::exception& error) {  // a verdict that cannot be kept is none: the next run would say otherwise
    return broken(candidate, criterion.suite, error.what());
  }
}

std::optional<Curves> keptCurves(const Workplace& workplace, const Store& store, const Candidate& candidate,
                                 const GradeOptions& options) {
  try {
    const auto text = store.read(curvesKey(workplace, candidate.manifest, candidate.objectKey, options), curvesSuffix);
    if (!text) return std::nullopt;
    const nlohmann::json document = nlohmann::json::parse(*text);
    return Curves{document.at("svgs").get<std::vector<std::string>>(), document.at("note").get<std::string>()};
  } catch (const std::exception&) {  // a disk has damaged them: they are drawn again
    return std::nullopt;
  }
}

Curves drawCurves(const Workplace& workplace, const Store& store, const Candidate& candidate,
                  const GradeOptions& options) {
  try {
    const TemporaryFolder folder(workplace.work());
    const fs::path figures = folder.path() / "figures";
    std::vector<std::string> command = commandFor(workplace, candidate, options, Look::First);
    command.insert(command.end(), {"--figures", figures.string()});
    const Verdict verdict = runHiddenProgram(workplace, candidate, curvesSuite, std::move(command), folder.path());
    if (!verdict.graderFault.empty()) return {{}, "the curves could not be drawn: " + verdict.graderFault};
    Curves curves{readSvgs(figures), verdict.fault};
    const bool isCertain = verdict.outcome == Outcome::Cpu || !isDoubtful(verdict);
    if (isCertain) {
      store.write(curvesKey(workplace, candidate.manifest, candidate.objectKey, options), curvesSuffix, toText(curves));
    }
    return curves;
  } catch (const std::exception& error) {
    return {{}, std::string("the curves could not be drawn: ") + error.what()};
  }
}

}  // namespace muelle::grader
