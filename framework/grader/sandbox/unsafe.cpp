#include "grader/sandbox/unsafe.h"

#include "grader/sandbox/staging.h"

namespace muelle::grader {

std::string Unsafe::description() const {
  return "UNSAFE: no sandbox. The compiler saw every file of this machine that its user may read; only limits and the "
         "worker's filter of system calls stood between the submission and the grader";
}

Sandbox::Prepared Unsafe::prepare(const Confinement& confinement) const {
  const auto staging = std::make_shared<StagingFolder>(confinement, -1);
  Prepared prepared;
  prepared.spec.command = confinement.command;
  prepared.spec.descriptors = confinement.descriptors;
  prepared.spec.environment = confinement.environment;
  prepared.spec.environment.emplace_back("PATH=/usr/bin");
  prepared.spec.environment.push_back("TMPDIR=" + staging->scratch().string());
  prepared.spec.limits = confinement.limits;
  prepared.spec.workingDirectory = staging->path();
  prepared.keepAlive = staging;
  return prepared;
}

}  // namespace muelle::grader
