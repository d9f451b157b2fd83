#include "course/check/compile_view.h"

#include "base/build_paths.h"
#include "base/file.h"
#include "course/check/compile_rules.h"

#include <utility>

namespace muelle {

namespace fs = std::filesystem;

namespace {

fs::path harnessOfCheckout() { return fs::path(build_paths::source) / "framework" / "harness"; }

}  // namespace

CompileView::CompileView(fs::path scratch, const fs::path& contract, const std::vector<StudentFile>& files)
    : scratch_(std::move(scratch)) {
  for (const char* folder : {"submission", "contract", "framework/harness"}) fs::create_directories(scratch_ / folder);
  for (const StudentFile& file : files) writeFile(source(file.name), file.text);
  fs::create_symlink(fs::absolute(contract), scratch_ / "contract" / contract.filename());
  // One by one: "harness/../figures" then leads nowhere, as in the sandbox.
  for (const auto& entry : fs::directory_iterator(harnessOfCheckout())) {
    if (entry.path().extension() != ".h") continue;
    fs::create_symlink(entry.path(), scratch_ / "framework" / "harness" / entry.path().filename());
  }
}

std::vector<std::string> CompileView::includeFlags(bool precompiled) const {
  // The folder is there either way, so that no source can ask which build it is part of.
  std::vector<std::string> flags{"-I", build_paths::prelude, "-include",
                                 precompiled ? "prelude.h" : "harness/exercise.h"};
  flags.insert(flags.end(), {"-I", (scratch_ / "contract").string(), "-I", (scratch_ / "framework").string(),
                             "-isystem", build_paths::eigen});
  return flags;
}

CompilePlace CompileView::place() const {
  CompilePlace place;
  place.folder = fs::current_path();
  place.visible = {scratch_ / "submission", scratch_ / "contract", scratch_ / "framework", build_paths::prelude,
                   build_paths::eigen};
  // clang lists what its precompiled header was made of.
  if (compilesWithClang()) place.visible.push_back(harnessOfCheckout());
  return place;
}

}  // namespace muelle
