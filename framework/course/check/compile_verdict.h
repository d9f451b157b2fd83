#pragma once
/// \file
/// Who is to blame when a student's file does not become a program.
///
/// The student is, when a diagnostic stands in a student's file or names a student's symbol or one of the contract.
/// Otherwise nobody is yet: the caller builds a file that is known to be good (probe.h) in the same place, and
/// afterProbe() decides. What only a tool's words say never decides, because a submission can make a compiler say
/// nearly anything.

#include "course/check/compile_rules.h"
#include "course/check/diagnostics.h"
#include "course/check/outcome.h"

#include <string>
#include <string_view>
#include <vector>

namespace muelle {

/// How a run of the compiler or of the linker ended.
struct ToolRun {
  std::string words{};  ///< what it wrote, in the C locale
  bool succeeded = false;
  bool timedOut = false;          ///< it passed the wall limit
  int signal = 0;                 ///< that ended the driver itself; 0: none
  double processorSeconds = 0.0;  ///< of all its processes; 0 when unknown
  bool endedFromOutside = false;  ///< whoever started it has seen no tool fail by itself; no tool's words say this
  bool wordsCut = false;          ///< it wrote more than was kept
};

/// What a build came to.
struct CompileVerdict {
  Outcome outcome = Outcome::Passed;  ///< Passed: the step is done; when undecided: what it is if the probe builds
  std::string message;                ///< one line: "it does not compile: spring_3d.cpp:5:10: ..."
  std::string diagnostics;            ///< errors in the student's lines; when it was built, warnings in them
  bool isDecided = true;              ///< false: build the probe, then ask afterProbe()
  bool isOurs = false;                ///< nobody's points are at stake: the machine or the course has failed
  bool wasKilled = false;             ///< from outside or at a wide limit: worth one more try alone
  bool endedFromOutside = false;      ///< by a wait status, not by words: never the student's, however often

  std::vector<std::string> hidden{};   ///< functions of the contract that are static, where no other error is
  std::vector<std::string> missing{};  ///< functions of the contract, where the linker complains of nothing else

  bool passed() const { return outcome == Outcome::Passed; }
};

/// True for a signal that a process does not draw by its own work, as it does SIGSEGV or a limit's SIGXCPU: SIGKILL,
/// SIGTERM ...
bool isFromOutside(int signal);

/// \param files the student's   \param limits those under which it ran, for the words of the verdict
CompileVerdict judgeCompilation(const ToolRun& run, const std::vector<StudentFile>& files, const CompileLimits& limits);

/// \param contract text of TOPIC.h   \param contractName "spring_3d.h"
CompileVerdict judgeLink(const ToolRun& run, const std::vector<StudentFile>& files, std::string_view contract,
                         std::string_view contractName, const CompileLimits& limits);

/// What an undecided verdict becomes: the student's when a known good file builds in the same place and nothing was
/// seen to be ended from outside, else ours.
CompileVerdict afterProbe(CompileVerdict verdict, bool probeBuilds);

}  // namespace muelle
