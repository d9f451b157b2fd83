#include "grader/run/grade.h"
#include "app/commands.h"
#include "base/progress_bar.h"
#include "base/terminal.h"
#include "grader/report/report.h"

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
  std::string out;
  std::string seed;
  std::string sandbox = "auto";
  int jobs = 0;
  bool unsafe = false;
  bool fresh = false;
};

/// out/NAME, so that two submissions do not write over each other.
fs::path reportFolder(const GradeCommand& command) {
  if (!command.out.empty()) return command.out;
  fs::path name = fs::path(command.submission).lexically_normal();
  if (name.filename().empty()) name = name.parent_path();  // "solutions/"
  return fs::path("out") / (name.stem().empty() || name.stem() == "." ? fs::path("submission") : name.stem());
}

/// One backend for the whole run: it is tried once, and every step is told which it is.
grader::SandboxChoice settleSandbox(const GradeCommand& command) {
  const auto wanted = command.unsafe ? grader::SandboxChoice::Unsafe : grader::parseSandboxChoice(command.sandbox);
  return grader::makeSandbox(wanted)->choice();
}

int gradeSubmission(const GradeCommand& command) {
  grader::GradeOptions options;
  options.seed = command.seed;
  options.fresh = command.fresh;
  options.sandbox = settleSandbox(command);
  const grader::GradingJob job = grader::openJob(grader::Workplace::ofThisBuild(), command.submission, options);
  const int jobs = command.jobs > 0 ? command.jobs : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));

  ProgressBar bar("grading");
  const grader::GradedSubmission graded =
      grader::grade(job, jobs, [&bar](int done, int all) { bar.update(static_cast<double>(done) / all); });

  const fs::path folder = reportFolder(command);
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

}  // namespace

void addGrade(CLI::App& app, int& status) {
  const auto options = std::make_shared<GradeCommand>();
  CLI::App* command = app.add_subcommand("grade", "Grade a submission with the hidden tests, in a sandbox");
  command
      ->add_option("SUBMISSION", options->submission,
                   "A folder or an archive (zip, tar, 7z) with TOPIC/TOPIC.cpp, or the files flat")
      ->required();
  command->add_option("--out", options->out, "Folder for report.html, results.json and results.xml [out/NAME]");
  command->add_option("--jobs,-j", options->jobs, "Tests at a time [the number of cores]")->check(CLI::Range(1, 256));
  command->add_option("--seed", options->seed,
                      "The instructor's seed, from which all random inputs derive [kept in the build folder]");
  command->add_option("--sandbox", options->sandbox, "auto, bubblewrap, landlock or unsafe [auto]");
  command->add_flag("--unsafe", options->unsafe, "No sandbox: only for files that you trust");
  command->add_flag("--fresh", options->fresh, "Build and run again what has been graded before");
  command->footer(
      "Exit code: 0 when it graded, whatever the score; 1 when the grader itself failed; 2 bad usage or input.\n"
      "Examples: ./muelle grade solutions\n"
      "          ./muelle grade hand-in.zip --out reports/hand-in");
  command->callback([options, &status] { status = gradeSubmission(*options); });
}

}  // namespace muelle::app
