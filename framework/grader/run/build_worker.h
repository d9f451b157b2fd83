#pragma once
#include "grader/run/workplace.h"
#include "grader/sandbox/sandbox.h"
#include "grader/verdict.h"

#include <map>
#include <string>

namespace muelle::grader {

/// The files that were handed in for one exercise: name -> content.
using Sources = std::map<std::string, std::string>;

/// Limits of one compilation.
struct CompileLimits {
  std::chrono::seconds time{20};
  std::size_t memory = 2048UL * 1024 * 1024;
  std::size_t scratch = 256UL * 1024 * 1024;
  std::size_t diagnostics = 64 * 1024;
  std::size_t product = 32UL * 1024 * 1024;
};

/// Names what a worker is made of: sources, contract, glue, flags, compiler. Equal keys, equal workers.
std::string workerKey(const Workplace& workplace, const Manifest& manifest, const Sources& sources);

/// Folder of the worker with that key: submission.so or build.json that says why there is none.
std::filesystem::path workerFolder(const Workplace& workplace, const std::string& key);
std::filesystem::path submissionObject(const Workplace& workplace, const std::string& key);

/// Compiles and links the sources into the worker's shared object, in the sandbox, unless that has been done.
/// Nothing but the finished object leaves the sandbox, through a pipe.
BuildOutcome buildWorker(const Workplace& workplace, const Manifest& manifest, const Sources& sources,
                         const Sandbox& sandbox, const CompileLimits& limits = {});

/// The outcome of the latest buildWorker; nullopt when there was none.
std::optional<BuildOutcome> readBuildOutcome(const Workplace& workplace, const std::string& key);

}  // namespace muelle::grader
