#include "grader/run/keys.h"

#include "base/errors.h"
#include "base/file.h"
#include "base/text/lists.h"
#include "course/check/symbols.h"
#include "grader/run/compile.h"
#include "grader/run/digest.h"
#include "grader/run/store.h"

#include <fmt/format.h>
#include <random>

namespace muelle::grader {

namespace fs = std::filesystem;

namespace {

std::string digestOfSources(const Sources& sources) {
  std::string content;
  for (const auto& [name, text] : sources) content += digest({name, text});
  return content;
}

/// "absent" where there is none: then grading says so, and no key stands in its way.
std::string digestOf(const fs::path& file) {
  std::error_code error;
  return fs::is_regular_file(file, error) ? digestOfFile(file) : "absent";
}

/// What runs a verdict's test, its entry in the manifest included.
std::string testingKey(const Workplace& workplace, const Manifest& manifest, const std::string& what,
                       const std::string& objectKey, const GradeOptions& options) {
  return digest({"verdict 5", objectKey, what, std::to_string(manifest.callSeconds),
                 digestOf(workplace.hiddenProgram(manifest.topic)), digestOf(workplace.host),
                 digestOf(workplace.sanitisedHost), options.forAuthors ? "for authors " + options.seed : options.seed});
}

void makeSeed(const fs::path& file) {
  std::random_device device;
  fs::create_directories(file.parent_path());
  const TemporaryFolder folder(file.parent_path());
  const fs::path fresh = folder.path() / file.filename();
  writeFile(fresh, fmt::format("{:08x}{:08x}{:08x}{:08x}", device(), device(), device(), device()), Durable::Yes);
  std::error_code taken;  // by another grader that started with us: its seed is the one
  fs::create_hard_link(fresh, file, taken);
}

}  // namespace

std::string objectKey(const Workplace& workplace, const Manifest& manifest, const Sources& sources,
                      SandboxChoice sandbox) {
  std::string headers;
  for (const VisibleFile& header : compilersView(workplace, manifest)) headers += digestOf(header.source);
  return digest({"object 5", manifest.topic, digestOfSources(sources), headers,
                 compileScript(workplace, sources, sandbox), compilerIdentity(workplace), toText(sandbox),
                 workplace.judgesSymbols ? symbolRules() : "unjudged"});
}

std::string verdictKey(const Workplace& workplace, const Manifest& manifest, const Criterion& criterion,
                       const std::string& objectKey, const GradeOptions& options) {
  const std::string what = fmt::format("{}:{}", criterion.suite, joined(criterion.functions, ","));
  if (criterion.follows.empty()) return testingKey(workplace, manifest, what, objectKey, options);
  const std::string follows =
      fmt::format("{}:{}:{}", what, joined(criterion.follows, ","), digestOf(workplace.reference(manifest.topic)));
  return testingKey(workplace, manifest, follows, objectKey, options);
}

std::string curvesKey(const Workplace& workplace, const Manifest& manifest, const std::string& objectKey,
                      const GradeOptions& options) {
  return testingKey(workplace, manifest, "curves", objectKey, options);
}

std::uint64_t inputSeed(const Manifest& manifest, const Sources& sources, const GradeOptions& options) {
  return keyedSeed(options.seed, manifest.topic + "/" + (options.forAuthors ? "" : digestOfSources(sources)));
}

std::string keptSeed(const Workplace& workplace) {
  const fs::path file = workplace.seedFile();
  try {
    if (!fs::exists(file)) makeSeed(file);
    return readFile(file);
  } catch (const std::system_error& error) {
    throw MachineFault(cannotKeep("the seed of the inputs", workplace.kept, error.code()));
  }
}

}  // namespace muelle::grader
