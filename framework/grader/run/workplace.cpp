#include "grader/run/workplace.h"

#include "base/build_paths.h"

#include <cstdlib>

namespace muelle::grader {

namespace fs = std::filesystem;

Workplace Workplace::ofThisBuild() {
  const fs::path binary = build_paths::binary;
  Workplace workplace;
  workplace.source = build_paths::source;
  workplace.binary = binary;
  const char* elsewhere = std::getenv("MUELLE_KEPT");
  workplace.kept = elsewhere != nullptr && *elsewhere != '\0' ? fs::path(elsewhere) : binary / "grade";
  workplace.compiler = fs::weakly_canonical(build_paths::compiler);
  workplace.host = binary / "bin" / "muelle-worker";
  workplace.sanitisedHost = binary / "bin" / "muelle-worker-asan";
  return workplace;
}

}  // namespace muelle::grader
