#include "grader/run/run_criterion.h"

#include "base/file.h"
#include "grader/record.h"
#include "grader/run/digest.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <algorithm>

namespace muelle::grader {

namespace {

namespace fs = std::filesystem;

constexpr auto processLimit = std::chrono::seconds(60);  // the session's own limits come long before
constexpr const char* curvesSuite = "curves";

fs::path recordFile(const Workplace& workplace, const std::string& key) {
  return workplace.records() / (key + ".json");
}

/// The inputs of an exercise follow from the instructor's seed and the files: another hand-in gets other numbers.
std::uint64_t inputSeed(const Manifest& manifest, const std::string& workerKey, const GradeOptions& options) {
  return keyedSeed(options.seed, manifest.topic + "/" + workerKey);
}

std::vector<std::string> commandFor(const Workplace& workplace, const Manifest& manifest, const std::string& workerKey,
                                    const GradeOptions& options) {
  return {workplace.hiddenProgram(manifest.topic).string(),
          "--topic",
          manifest.topic,
          "--worker",
          submissionObject(workplace, workerKey).string(),
          "--host",
          workplace.host().string(),
          "--core-locks",
          workplace.coreLocks().string(),
          "--sandbox",
          toText(options.sandbox),
          "--seed",
          std::to_string(inputSeed(manifest, workerKey, options))};
}

/// Runs a hidden test program; its record, or a verdict that says what is wrong with us.
Verdict runHiddenProgram(const Workplace& workplace, const Manifest& manifest, const std::string& suite,
                         std::vector<std::string> command, const std::string& key) {
  fs::create_directories(workplace.records());
  const fs::path file = recordFile(workplace, key);
  fs::remove(file);
  command.insert(command.end(), {"--record", file.string()});
  Verdict broken;
  broken.topic = manifest.topic;
  broken.suite = suite;
  try {
    ChildSpec spec;
    spec.command = command;
    spec.environment = {"PATH=/usr/bin:/bin", "LC_ALL=C.UTF-8"};
    Capture capture;
    capture.limit = processLimit;
    const CommandResult result = runCommand(spec, capture);
    if (const auto verdict = readRecord(file); verdict && verdict->topic == manifest.topic && verdict->suite == suite) {
      return *verdict;
    }
    broken.graderFault = fmt::format("the test program of {} left no record ({}): {}", manifest.topic,
                                     result.timedOut ? "it took too long" : fmt::format("exit {}", result.status.code),
                                     result.err.substr(0, 500));
  } catch (const std::exception& error) {
    broken.graderFault = error.what();
  }
  writeRecord(broken, file);
  return broken;
}

fs::path curvesFolder(const Workplace& workplace, const std::string& key) { return workplace.figures() / key; }

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

}  // namespace

std::string verdictKey(const Workplace& workplace, const Manifest& manifest, const std::string& suite,
                       const std::string& workerKey, const GradeOptions& options) {
  return digest({workerKey, suite, digestOfFile(workplace.hiddenProgram(manifest.topic)),
                 digestOfFile(workplace.host()), options.seed, toText(options.sandbox)});
}

std::string curvesKey(const Workplace& workplace, const Manifest& manifest, const std::string& workerKey,
                      const GradeOptions& options) {
  return verdictKey(workplace, manifest, curvesSuite, workerKey, options);
}

std::optional<Verdict> writtenVerdict(const Workplace& workplace, const std::string& key) {
  return readRecord(recordFile(workplace, key));
}

std::optional<Verdict> keptVerdict(const Workplace& workplace, const std::string& key) {
  auto verdict = writtenVerdict(workplace, key);
  if (verdict && !verdict->graderFault.empty()) return std::nullopt;
  return verdict;
}

void forgetVerdict(const Workplace& workplace, const std::string& key) {
  fs::remove(recordFile(workplace, key));
  fs::remove_all(curvesFolder(workplace, key));
}

Verdict runCriterion(const Workplace& workplace, const Manifest& manifest, const Criterion& criterion,
                     const std::string& workerKey, const GradeOptions& options) {
  const std::string key = verdictKey(workplace, manifest, criterion.suite, workerKey, options);
  if (!options.fresh) {
    if (const auto kept = keptVerdict(workplace, key)) return *kept;
  }
  std::vector<std::string> command = commandFor(workplace, manifest, workerKey, options);
  command.insert(command.end(), {"--suite", criterion.suite});
  if (!criterion.functions.empty()) {
    command.insert(command.end(), {"--functions", fmt::format("{}", fmt::join(criterion.functions, ","))});
  }
  return runHiddenProgram(workplace, manifest, criterion.suite, std::move(command), key);
}

std::optional<Curves> keptCurves(const Workplace& workplace, const Manifest& manifest, const std::string& workerKey,
                                 const GradeOptions& options) {
  const std::string key = curvesKey(workplace, manifest, workerKey, options);
  const auto verdict = keptVerdict(workplace, key);
  if (!verdict) return std::nullopt;
  return Curves{readSvgs(curvesFolder(workplace, key)), verdict->fault};
}

Curves drawCurves(const Workplace& workplace, const Manifest& manifest, const std::string& workerKey,
                  const GradeOptions& options) {
  if (!options.fresh) {
    if (auto kept = keptCurves(workplace, manifest, workerKey, options)) return *kept;
  }
  const std::string key = curvesKey(workplace, manifest, workerKey, options);
  const fs::path folder = curvesFolder(workplace, key);
  std::vector<std::string> command = commandFor(workplace, manifest, workerKey, options);
  command.insert(command.end(), {"--figures", folder.string()});
  const Verdict verdict = runHiddenProgram(workplace, manifest, curvesSuite, std::move(command), key);
  if (!verdict.graderFault.empty()) {
    return {{}, "the curves could not be drawn: " + verdict.graderFault};
  }
  return {readSvgs(folder), verdict.fault};
}

}  // namespace muelle::grader
