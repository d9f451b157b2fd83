#include "grader/run/grade.h"

#include "base/file.h"
#include "course/check/handed_out.h"
#include "course/unfinished.h"
#include "grader/run/exercise_run.h"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <algorithm>
#include <chrono>
#include <ctime>
#include <mutex>
#include <set>

namespace muelle::grader {

namespace {

using Status = BuildOutcome::Status;

constexpr std::uintmax_t largestStore = 2ULL << 30;  // [bytes] objects, and as much for records

/// A submission of which exercises are still being graded.
struct Unfinished {
  std::mutex mutex;
  GradedSubmission graded;
  std::size_t missing = 0;
  std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();
  std::function<void(GradedSubmission)> done;

  void finish() {
    graded.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    done(std::move(graded));
  }
};

/// The files to hand in as they are handed out.
SourcesByTopic readStubs(const Workplace& workplace, const std::vector<Manifest>& course) {
  SourcesByTopic stubs;
  for (const Manifest& manifest : course) {
    for (const std::string& name : manifest.files) {
      const std::filesystem::path file = workplace.exercises() / manifest.topic / name;
      std::error_code unknown;
      if (std::filesystem::is_regular_file(file, unknown)) stubs[manifest.topic][name] = readFile(file);
    }
  }
  return stubs;
}

/// Sources of one exercise, or null when they are missing or refused.
const Sources* sourcesOf(const Submission& submission, const Manifest& manifest) {
  const auto found = submission.sources.find(manifest.topic);
  if (found == submission.sources.end() || found->second.size() != manifest.files.size()) return nullptr;
  return &found->second;
}

std::string entryOf(const std::map<std::string, std::string>& entries, const std::string& topic) {
  const auto found = entries.find(topic);
  return found == entries.end() ? "" : found->second;
}

/// Why there is nothing to build: refused, unreadable for us, or not handed in.
BuildOutcome absence(const Submission& submission, const Manifest& manifest) {
  BuildOutcome outcome;
  outcome.status = Status::GraderFault;
  outcome.message = entryOf(submission.faults, manifest.topic);
  if (!outcome.message.empty()) return outcome;
  outcome.status = Status::Refused;
  outcome.message = entryOf(submission.refused, manifest.topic);
  if (!outcome.message.empty()) return outcome;
  outcome.status = Status::Missing;
  outcome.message = entryOf(submission.missing, manifest.topic);
  if (outcome.message.empty()) outcome.message = fmt::format("the submission has no {}", manifest.files.front());
  return outcome;
}

/// How the files were taken; and that the student's contract is another one, which explains an error of the compiler
/// that their own machine does not have.
std::string noteOn(const Submission& submission, const std::string& topic, const std::filesystem::path& contract) {
  std::string note = entryOf(submission.taken, topic);
  const auto theirs = submission.contracts.find(topic);
  if (theirs == submission.contracts.end()) return note;
  const std::uint64_t ours = handedOutHash(readFile(contract));
  if (std::ranges::all_of(theirs->second, [ours](std::uint64_t hash) { return hash == ours; })) return note;
  return note + fmt::format("{}your {}.h is not the one that was handed out; the grader uses its own",
                            note.empty() ? "" : "; ", topic);
}

}  // namespace

Grader::Grader(Workplace workplace, std::vector<Manifest> course, GradeOptions options,
               std::unique_ptr<Sandbox> sandbox, std::vector<Manifest> wholeCourse)
    : workplace_(std::move(workplace)),
      course_(std::move(course)),
      wholeCourse_(wholeCourse.empty() ? course_ : std::move(wholeCourse)),
      stubs_(readStubs(workplace_, wholeCourse_)),
      options_(std::move(options)),
      sandbox_(std::move(sandbox)),
      objects_(workplace_.objects()),
      records_(workplace_.records()) {
  options_.sandbox = sandbox_->choice();
  if (options_.seed.empty()) options_.seed = keptSeed(workplace_);
}

void Grader::count(std::atomic<int>& counter, int by) {
  counter += by;
  if (listener_) listener_();
}

Submission Grader::take(const std::filesystem::path& path) const { return take(std::vector{path}); }

Submission Grader::take(const std::vector<std::filesystem::path>& parts) const {
  std::vector<std::string> only;
  if (course_.size() < wholeCourse_.size()) {
    for (const Manifest& manifest : course_) only.push_back(manifest.topic);
  }
  return takeSubmission(parts, wholeCourse_, {}, only, stubs_);
}

void Grader::add(Pool& pool, const Submission& submission, std::function<void(GradedSubmission)> done) {
  const auto unfinished = std::make_shared<Unfinished>();
  unfinished->done = std::move(done);
  GradedSubmission& graded = unfinished->graded;
  graded.name = submission.name;
  graded.intakeNotes = submission.notes;
  graded.sandbox = sandbox_->description();
  graded.date = fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr)));
  graded.exercises.resize(course_.size());
  unfinished->missing = course_.size();
  for (std::size_t i = 0; i < course_.size(); ++i) {
    const Manifest& manifest = course_[i];
    addExercise(pool, manifest, sourcesOf(submission, manifest), absence(submission, manifest),
                [unfinished, i, note = noteOn(submission, manifest.topic, workplace_.contract(manifest.topic))](
                    GradedExercise exercise) {
                  exercise.note = note;
                  std::unique_lock lock(unfinished->mutex);
                  unfinished->graded.exercises[i] = std::move(exercise);
                  if (--unfinished->missing > 0) return;
                  lock.unlock();
                  unfinished->finish();
                });
  }
}

void Grader::addExercise(Pool& pool, const Manifest& manifest, const Sources* sources, const BuildOutcome& otherwise,
                         std::function<void(GradedExercise)> done) {
  const auto run = std::make_shared<ExerciseRun>(*this, pool, manifest, std::move(done));
  if (sources != nullptr) {
    count(known_);
    pool.append([run, copy = *sources]() mutable { run->begin(std::move(copy)); });
  } else {
    pool.append([run, otherwise] { run->leaveOut(otherwise); });
  }
}

void Grader::prune() const {
  objects_.prune(largestStore);
  records_.prune(largestStore);
  removeAbandonedFolders(workplace_.work());
}

Grader openGrader(const Workplace& workplace, GradeOptions options, const std::vector<std::string>& only) {
  std::vector<Manifest> course;
  const std::vector<Manifest> all = readCourse(workplace.exercises());
  for (const std::string& topic : std::set<std::string>(only.begin(), only.end())) {  // named twice, it counts once
    course.push_back(findExercise(all, topic));
  }
  if (only.empty()) course = all;
  const auto unfinished = unfinishedExercises(workplace.binary);
  std::erase_if(course, [&](const Manifest& manifest) {
    std::error_code missing;
    return unfinished.contains(manifest.topic) ||
           !std::filesystem::exists(workplace.hiddenProgram(manifest.topic), missing);
  });
  if (course.empty()) {
    for (const std::string& topic : only) {
      if (unfinished.contains(topic)) throw std::runtime_error(sayUnfinished(topic, unfinished.at(topic)));
    }
    throw std::runtime_error("no hidden tests are built: build the target muelle_grading, or call ./muelle grade");
  }
  std::ranges::sort(course, {}, &Manifest::order);
  auto sandbox = makeSandbox(options.sandbox);
  return {workplace, std::move(course), std::move(options), std::move(sandbox), all};
}

GradedSubmission grade(Grader& grader, const Submission& submission, int jobs) {
  GradedSubmission result;
  Pool pool(jobs);
  grader.add(pool, submission, [&result](GradedSubmission graded) { result = std::move(graded); });
  pool.run();
  grader.prune();
  return result;
}

}  // namespace muelle::grader
