#include "grader/run/workplace.h"

#include "base/build_paths.h"

namespace muelle::grader {

Workplace Workplace::ofThisBuild() { return {build_paths::source, build_paths::binary}; }

}  // namespace muelle::grader
