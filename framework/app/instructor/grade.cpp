#include "grader/run/grade.h"
#include "app/commands.h"
#include "base/progress_bar.h"
#include "base/terminal.h"
#include "grader/class/grade_class.h"
#include "grader/intake/looks_like_a_class.h"
#include "grader/report/report.h"
#include "grader/report/report_folder.h"

#include <fmt/format.h>
#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>
#include <thread>

namespace muelle::app {

namespace fs = std::filesystem;

namespace {

struct GradeCommand {
  std::string submission;
  std::string classFolder;
  std::string out;
  std::string seed;
  std::string sandbox = "auto";
  std::vector<std::string> only;
  int jobs = 0;
  bool unsafe = false;
  bool fresh = false;
};

grader::Grader openGrader(const GradeCommand& command) {
  grader::GradeOptions options;
  options.seed = command.seed;
  options.fresh = command.fresh;
  options.sandbox = command.unsafe ? grader::SandboxChoice::Unsafe : grader::parseSandboxChoice(command.sandbox);
  return grader::openGrader(grader::Workplace::ofThisBuild(), options, command.only);
}

int jobsOf(const GradeCommand& command) {
  return command.jobs > 0 ? command.jobs : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

int gradeSubmission(const GradeCommand& command) {
  grader::Grader grader = openGrader(command);
  if (const auto why = grader::looksLikeAClass(command.submission, grader.wholeCourse())) {
    throw std::invalid_argument(command.submission + " " + *why);
  }
  grader::Submission submission = grader.take(command.submission);
  ProgressBar bar("grading");
  grader.onProgress([&] { bar.update(static_cast<double>(grader.finished()) / std::max(1, grader.known())); });
  const grader::GradedSubmission graded = grader::grade(grader, submission, jobsOf(command));

  const fs::path folder = command.out.empty() ? grader::reportFolder("out", command.submission) : fs::path(command.out);
  grader::writeReports(graded, folder);
  fmt::print("{}", grader::terminalTable(graded, coloursWanted(), terminalWidth()));
  fmt::print("\nreport: {}\n        {}\n        {}\n", (folder / "report.html").string(),
             (folder / "results.json").string(), (folder / "results.xml").string());
  if (!grader::hasGraderFault(graded)) return 0;
  fmt::print(stderr,
             "muelle: the grader itself failed on some criteria, which have no score: grade again, or look into {}\n",
             (folder / "report.html").string());
  return 1;
}

int gradeClass(const GradeCommand& command) {
  grader::Grader grader = openGrader(command);
  grader::ClassOptions options;
  options.folder = command.classFolder;
  options.out = command.out.empty() ? grader::reportFolder("out", command.classFolder) : fs::path(command.out);
  options.jobs = jobsOf(command);
  ProgressBar bar("grading the class");
  const grader::GradedClass graded =
      grader::gradeClass(grader, options, [&bar](double fraction) { bar.update(fraction); });
  fmt::print("{}", grader::classTable(graded, coloursWanted(), terminalWidth()));
  fmt::print("\nclass:  {}\ngrades: {}\n", (options.out / "class.html").string(),
             (options.out / "grades.csv").string());
  if (!graded.hasFault()) return 0;
  fmt::print(stderr,
             "muelle: {} of {} submissions have no score (see the notes): mend what is broken, then type the "
             "same command again\n",
             graded.faults(), graded.rows.size());
  return 1;
}

int run(const GradeCommand& command) {
  const bool isClass = !command.classFolder.empty();
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
  command.option("--only", options->only, "Only these exercises, separated by commas").separator(',');
  command.option("--out", options->out, "Folder for the reports [out/NAME]");
  command.option("--jobs,-j", options->jobs, "Tests at a time [the number of cores]").range(1, 256);
  command.option("--seed", options->seed,
                 "The instructor's seed, from which all random inputs derive [kept in the build folder]");
  command.option("--sandbox", options->sandbox, "auto, bubblewrap, landlock or unsafe [auto]");
  command.flag("--unsafe", options->unsafe, "No sandbox: only for files that you trust");
  command.flag("--fresh", options->fresh, "Build and run again what has been graded before");
  command.footer(
      "Exit code: 0 when it graded, whatever the score; 1 when the grader itself failed on something, which then has\n"
      "no score (type the same command again); 2 bad usage or input.\n"
      "Examples: ./muelle grade solutions\n"
      "          ./muelle grade hand-in.zip --out reports/hand-in\n"
      "          ./muelle grade --class submissions --only spring_1d,spring_3d");
  command.action([options] { return run(*options); });
}

}  // namespace muelle::app
