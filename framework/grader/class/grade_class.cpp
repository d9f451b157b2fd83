#include "grader/class/grade_class.h"

#include "base/file.h"
#include "grader/authors/grade_again.h"
#include "grader/intake/class_folder.h"
#include "grader/report/report.h"
#include "grader/report/report_folder.h"

#include <algorithm>
#include <map>
#include <memory>
#include <mutex>
#include <stdexcept>

namespace muelle::grader {

namespace fs = std::filesystem;

namespace {

/// One class being graded: rows are filled by tasks of the pool.
class Grading {
 public:
  Grading(Grader& grader, const ClassOptions& options, const std::function<void(double)>& progress)
      : grader_(grader), options_(options), progress_(progress), pool_(options.jobs) {}

  GradedClass run() {
    const ClassFolder folder = listClass(options_.folder);
    class_.name = fs::canonical(options_.folder).filename().string();
    class_.course = grader_.course();
    class_.sandbox = grader_.sandbox().description();
    class_.notes = folder.notes;
    class_.rows.resize(folder.entries.size());
    if (folder.entries.empty()) {
      throw std::runtime_error("no submission in " + options_.folder.string() +
                               ": each of its children, folder or archive, is taken for one");
    }
    for (std::size_t i = 0; i < folder.entries.size(); ++i) {
      pool_.append([this, i, &entry = folder.entries[i]] { open(i, entry); });
    }
    pool_.run();
    if (options_.unnamed) class_.unnamed = gradeAgain(grader_.workplace(), grader_.options(), inOrder(), options_.jobs);
    write();
    grader_.prune();
    return std::move(class_);
  }

 private:
  /// Reads one hand-in and adds its grading; one that cannot be read is a row with a note.
  void open(std::size_t i, const ClassEntry& entry) {
    ClassRow& row = class_.rows[i];
    row.student = entry.student;
    try {
      if (!entry.refusal.empty()) throw std::runtime_error(entry.refusal);
      Submission submission = grader_.take(entry.parts);
      submission.name = entry.student;
      const auto sources = options_.unnamed ? std::make_shared<const SourcesByTopic>(submission.sources) : nullptr;
      grader_.add(pool_, submission, [this, i, sources, path = entry.parts.front()](GradedSubmission graded) {
        if (sources) noteUnnamed(i, graded, *sources);
        finish(i, path, std::move(graded));
      });
    } catch (const std::exception& error) {
      row.trouble = error.what();
      forget(row, entry.parts.front());
      count();
    }
  }

  /// What is graded once more when all is done, for those that are compared.
  void noteUnnamed(std::size_t i, const GradedSubmission& graded, const SourcesByTopic& sources) {
    const std::lock_guard lock(mutex_);
    for (const GradedExercise& exercise : graded.exercises) {
      if (unnamedMistakes(exercise).empty()) continue;
      unnamed_[i].push_back({class_.rows[i].student, exercise.manifest, sources.at(exercise.manifest.topic)});
    }
  }

  /// In the order of the students, whichever was graded first.
  std::vector<UnnamedHandIn> inOrder() const {
    std::vector<UnnamedHandIn> all;
    for (const auto& [i, handIns] : unnamed_) all.insert(all.end(), handIns.begin(), handIns.end());
    return all;
  }

  void finish(std::size_t i, const fs::path& path, GradedSubmission graded) {
    ClassRow& row = class_.rows[i];
    try {
      const fs::path folder = reportFolder(reports(), path);
      writeReports(graded, folder);
      row.report = (folder.lexically_relative(options_.out) / "report.html").generic_string();
    } catch (const std::exception& error) {
      row.reportFault = error.what();
      forget(row, path);
    }
    for (GradedExercise& exercise : graded.exercises) {  // in the report; 300 students' would fill the memory
      exercise.figures.clear();
      exercise.figures.shrink_to_fit();
    }
    row.graded = std::move(graded);
    count();
  }

  /// Whoever has no report of this run keeps none of an earlier one, which may hold a score.
  void forget(ClassRow& row, const fs::path& path) {
    try {
      if (const auto old = findReportFolder(reports(), path)) removeReports(*old);
    } catch (const std::exception& error) {
      row.reportFault = error.what();
    }
  }

  fs::path reports() const { return options_.out / "reports"; }

  void count() {
    const std::lock_guard lock(mutex_);
    ++done_;
    if (progress_) progress_(static_cast<double>(done_) / static_cast<double>(class_.rows.size()));
  }

  void write() {
    try {
      claim(options_.out, options_.folder);
      writeFile(options_.out / "grades.csv", gradesCsv(class_), Durable::Yes);
      writeFile(options_.out / "class.html", classPage(class_), Durable::Yes);
    } catch (const std::exception& error) {
      class_.outFault = error.what();
    }
  }

  Grader& grader_;
  const ClassOptions& options_;
  const std::function<void(double)>& progress_;
  Pool pool_;
  GradedClass class_;
  std::map<std::size_t, std::vector<UnnamedHandIn>> unnamed_;  ///< by row
  std::mutex mutex_;
  std::size_t done_ = 0;
};

}  // namespace

GradedClass gradeClass(Grader& grader, const ClassOptions& options, const std::function<void(double)>& progress) {
  return Grading(grader, options, progress).run();
}

}  // namespace muelle::grader
