#include "lab/run/shipped_scenes.h"

#include "base/build_paths.h"

namespace muelle::lab {

std::filesystem::path shippedScenes() {
  return std::filesystem::path(build_paths::source) / "framework" / "engine" / "scenes";
}

}  // namespace muelle::lab
