#include "app/instructor/commands.h"
#include "app/commands.h"

namespace muelle::app {

void addInstructorCommands(CommandLine& program) {
#if MUELLE_HAS_GRADER
  addGrade(program);
  addNew(program);
  addLint(program);
  addTestTheTests(program);
  addClean(program);
  addHandout(program);
#endif
#if MUELLE_HAS_ENGINE
  addRun(program);
  addRest(program);
  addAdvise(program);
  addHardCases(program);
  addBench(program);
  addFigures(program);
#endif
  addTest(program);
  addDocs(program);
}

void printInstructorSteps() {
#if MUELLE_HAS_GRADER
  printStep("./muelle grade FOLDER", "grade a submission (./muelle grade solutions: the reference)");
  printStep("./muelle handout FOLDER", "the tree that students get");
  printStep("./muelle new TOPIC", "begin an exercise");
  printStep("./muelle lint", "what do the exercises lack?");
  printStep("./muelle test-the-tests", "does every wrong submission lose what it must?");
  printStep("./muelle test", "the tests of the framework");
  printStep("./muelle docs", "write the documentation");
#endif
#if MUELLE_HAS_ENGINE
  printStep("./muelle run elastic_pendulum --plot", "simulate a scene: error, energy, cost, curves");
  printStep("./muelle rest hanging_chain --plot", "where a scene stands still: stable or not, tensions");
  printStep("./muelle figures", "draw the figures of the lecture");
  printStep("./muelle hard-cases", "every method on every hard case");
  printStep("./muelle bench --quick", "speed against error, beside other libraries");
#endif
}

}  // namespace muelle::app
