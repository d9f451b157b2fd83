#include "grader/run/grade.h"
#include "app/instructor/commands.h"
#include "base/errors.h"
#include "base/file.h"
#include "base/progress_bar.h"
#include "base/terminal.h"
#include "base/text/lists.h"
#include "grader/authors/mistake_text.h"
#include "grader/class/grade_class.h"
#include "grader/intake/looks_like_a_class.h"
#include "grader/report/report.h"
#include "grader/report/report_folder.h"

#include <fmt/format.h>
#include <unistd.h>
#include <algorithm>
#include <cerrno>
#include <exception>
#include <filesystem>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <thread>

namespace muelle::app {

namespace fs = std::filesystem;

namespace {

constexpr const char* everything = "*";
constexpr const char* defaultParent = "out";

struct GradeCommand {
  std::string submission;
  std::string classFolder;
  std::string out;
  std::string seed;
  std::string sandbox;
  std::string only = everything;
  int jobs = 0;
  bool unsafe = false;
  bool fresh = false;
  bool unnamed = false;
};

/// The words of "spring_1d,spring_3d".
std::vector<std::string> topicsOf(const GradeCommand& command) {
  std::vector<std::string> topics;
  if (command.only == everything) return topics;
  for (const std::string& word : parted(command.only, ",")) {
    if (!word.empty()) topics.push_back(word);
  }
  if (topics.empty()) throw std::invalid_argument("--only names no exercise: ./muelle list names them");
  return topics;
}

/// Who builds a part of the course (-D MUELLE_TOPICS=...) is told what has no points for that.
void sayNotBuilt(const GradeCommand& command, const grader::Grader& grader) {
  if (command.only != everything) return;
  std::vector<std::string> absent;
  for (const Manifest& exercise : grader.wholeCourse()) {
    const auto isIt = [&](const Manifest& built) { return built.topic == exercise.topic; };
    if (std::ranges::none_of(grader.course(), isIt)) absent.push_back(exercise.topic);
  }
  if (!absent.empty()) fmt::print(stderr, "note: not built, and not graded: {}\n", joined(absent, ", "));
}

grader::Grader openGrader(const GradeCommand& command) {
  if (command.unsafe && !command.sandbox.empty() && command.sandbox != "unsafe") {
    throw std::invalid_argument(
        fmt::format("--unsafe is no sandbox, --sandbox {} is one: give one of the two", command.sandbox));
  }
  grader::GradeOptions options;
  options.seed = command.seed;
  options.fresh = command.fresh;
  options.sandbox = command.unsafe ? grader::SandboxChoice::Unsafe : grader::parseSandboxChoice(command.sandbox);
  return grader::openGrader(grader::Workplace::ofThisBuild(), options, topicsOf(command));
}

int jobsOf(const GradeCommand& command) {
  return command.jobs > 0 ? command.jobs : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

/// Where the reports go, when that is asked for; what would overwrite or hand in another's is refused before the work.
std::optional<fs::path> givenFolder(const GradeCommand& command, const std::string& submission) {
  grader::requireOutside(command.out.empty() ? fs::path(defaultParent) : fs::path(command.out), submission);
  if (command.out.empty()) return std::nullopt;
  std::error_code absent;
  if (fs::exists(command.out, absent) && !fs::is_directory(command.out, absent)) {
    throw std::invalid_argument(fmt::format("--out {}: that is no folder; name one for the reports", command.out));
  }
  grader::requireOwn(command.out, submission);
  return command.out;
}

/// The folder of the reports, made and marked.
fs::path madeFolder(const std::optional<fs::path>& given, const std::string& submission) {
  if (!given) return grader::reportFolder(defaultParent, submission);
  grader::claim(*given, submission);
  return *given;
}

bool isForbidden(const fs::path& path) { return ::access(path.c_str(), R_OK) != 0 && errno == EACCES; }

/// A submission that cannot be taken any more keeps no score of an earlier run.
grader::Submission take(const grader::Grader& grader, const GradeCommand& command,
                        const std::optional<fs::path>& given) {
  try {
    return grader.take(command.submission);
  } catch (const std::exception& error) {
    const auto old = given ? given : grader::findReportFolder(defaultParent, command.submission);
    if (old && grader::isOwn(*old, command.submission)) grader::removeReports(*old);
    if (isForbidden(command.submission)) throw MachineFault(error.what());
    throw;
  }
}

/// Writes the reports; where that fails, the table is printed all the same, and the failure told after it.
int report(const grader::GradedSubmission& graded, const GradeCommand& command, const std::optional<fs::path>& given) {
  fs::path folder;
  std::exception_ptr unwritten;
  try {
    folder = madeFolder(given, command.submission);
    grader::writeReports(graded, folder);
  } catch (const std::exception&) {
    unwritten = std::current_exception();
  }
  fmt::print("{}", grader::terminalTable(graded, coloursWanted(), terminalWidth()));
  if (unwritten) std::rethrow_exception(unwritten);
  fmt::print("\nreport: {}\n        {}\n        {}\n", (folder / "report.html").string(),
             (folder / "results.json").string(), (folder / "results.xml").string());
  if (!grader::hasGraderFault(graded)) return 0;
  fmt::print(stderr,
             "muelle: the grader itself failed on some criteria, which have no score: grade again, or look into {}\n",
             (folder / "report.html").string());
  return 1;
}

int gradeSubmission(const GradeCommand& command) {
  grader::Grader grader = openGrader(command);
  sayNotBuilt(command, grader);
  if (const auto why = grader::looksLikeAClass(command.submission, grader.wholeCourse())) {
    throw std::invalid_argument(command.submission + " " + *why);
  }
  const std::optional<fs::path> given = givenFolder(command, command.submission);
  grader::Submission submission = take(grader, command, given);
  if (const auto note = grader::archiveOfAClass(submission.archived, grader.wholeCourse())) {
    submission.notes.push_back(*note);
  }
  ProgressBar bar("grading");
  grader.onProgress([&] { bar.update(static_cast<double>(grader.finished()) / std::max(1, grader.known())); });
  return report(grader::grade(grader, submission, jobsOf(command)), command, given);
}

/// One line of what went wrong with the class, for whoever reads no table; "" when nothing did.
std::string whatFailed(const grader::GradedClass& graded) {
  if (!graded.outFault.empty()) return graded.outFault;
  if (graded.hasFault()) {
    return fmt::format(
        "{} of {} submissions have no score (see the notes): mend what is broken, then type the same command again",
        graded.faults(), graded.rows.size());
  }
  const std::size_t missing = graded.missingReports().size();
  if (missing == 0) return "";
  return fmt::format(
      "{} of {} submissions have no report (see the notes): mend what is broken, then type the same command again",
      missing, graded.rows.size());
}

int gradeClass(const GradeCommand& command) {
  grader::Grader grader = openGrader(command);
  sayNotBuilt(command, grader);
  const std::optional<fs::path> given = givenFolder(command, command.classFolder);
  grader::ClassOptions options;
  options.folder = command.classFolder;
  options.out = given ? *given : grader::reportFolder(defaultParent, command.classFolder);
  options.jobs = jobsOf(command);
  options.unnamed = command.unnamed;
  ProgressBar bar("grading the class");
  const grader::GradedClass graded =
      grader::gradeClass(grader, options, [&bar](double fraction) { bar.update(fraction); });
  fmt::print("{}", grader::classTable(graded, coloursWanted(), terminalWidth()));
  if (graded.outFault.empty()) {
    fmt::print("\nclass:  {}\ngrades: {}\n", (options.out / "class.html").string(),
               (options.out / "grades.csv").string());
  }
  for (const grader::UnnamedGroup& group : graded.unnamed) {
    fmt::print("\n{}", grader::groupText(group, readFile(grader.workplace().contract(group.topic))));
  }
  const std::string failure = whatFailed(graded);
  if (!failure.empty()) throw MachineFault(failure);
  return 0;
}

int run(const GradeCommand& command) {
  const bool isClass = !command.classFolder.empty();
  if (command.unnamed && !isClass) throw std::invalid_argument("--unnamed compares hand-ins: it goes with --class");
  if (isClass == !command.submission.empty()) {
    throw std::invalid_argument("give one submission, or --class FOLDER with a submission in each child");
  }
  return isClass ? gradeClass(command) : gradeSubmission(command);
}

}  // namespace

void addGrade(CommandLine& program) {
  const auto options = std::make_shared<GradeCommand>();
  CommandLine& command = program.command("grade", "Grade submissions with the hidden tests, in a sandbox");
  command.option("SUBMISSION", options->submission,
                 "A folder or an archive (zip, tar, 7z) with TOPIC/TOPIC.cpp, or the files flat");
  command.option("--class", options->classFolder, "A folder in which each child is one submission");
  command.option("--only", options->only, "Only these exercises, in one word with commas between them");
  command.option("--out", options->out, "Folder for the reports [out/NAME]");
  command.option("--jobs,-j", options->jobs, "Tests at a time [the number of cores]").range(1, 256);
  command.option("--seed", options->seed,
                 "The instructor's seed, from which all random inputs derive [kept in the build folder]");
  command.option("--sandbox", options->sandbox, "auto, bubblewrap, landlock or unsafe [auto]");
  command.flag("--unsafe", options->unsafe, "No sandbox: only for files that you trust");
  command.flag("--unnamed", options->unnamed,
               "With --class: group the hand-ins without a name by their answers, each group with a MUELLE_MISTAKE");
  command.flag("--fresh", options->fresh, "Build and run again what has been graded before");
  command.footer(
      "Exit code: 0 when it graded, whatever the score; 1 when the grader itself failed on something, which then has\n"
      "no score (type the same command again); 2 bad usage or input.\n"
      "Examples: ./muelle grade solutions\n"
      "          ./muelle grade hand-in.zip --out reports/hand-in\n"
      "          ./muelle grade --class submissions --only spring_1d,spring_3d\n"
      "          ./muelle grade --class submissions --unnamed");
  command.action([options] { return blamingTheMachine([options] { return run(*options); }); });
}

}  // namespace muelle::app
