#include "grader/run/replaced_object.h"

#include "grader/run/digest.h"

#include <fmt/format.h>

namespace muelle::grader {

namespace fs = std::filesystem;

namespace {

constexpr const char* objectSuffix = ".so";
constexpr const char* digestSuffix = ".sha";

/// The kept one, unless a disk has damaged it.
std::optional<fs::path> keptObject(const Store& objects, const std::string& key) {
  const auto expected = objects.read(key, digestSuffix);
  const auto content = expected ? objects.read(key, objectSuffix) : std::nullopt;
  if (!content || digestOfBytes(*content) != *expected) return std::nullopt;
  return objects.file(key, objectSuffix);
}

}  // namespace

fs::path partsOf(const fs::path& object) { return object.string() + ".parts"; }

std::optional<fs::path> replacedObject(const Workplace& workplace, const Store& objects, const Sandbox& sandbox,
                                       const Manifest& manifest, const std::string& objectKey,
                                       const std::vector<std::string>& functions, const fs::path& object, Build build) {
  const fs::path reference = workplace.reference(manifest.topic);
  std::error_code error;
  if (!fs::is_regular_file(reference, error) || !fs::is_regular_file(partsOf(object), error)) return std::nullopt;
  const std::string key = digest({"replaced 1", objectKey, digestOfFile(object), digestOfFile(reference),
                                  replacingScript(workplace, functions, sandbox.choice(), build)});
  if (auto kept = keptObject(objects, key)) return kept;
  const auto link = [&] { return linkReplaced(workplace, manifest, partsOf(object), functions, sandbox, build); };
  std::optional<std::string> linked = link();
  if (!linked) linked = link();  // what has failed twice is not the machine
  if (!linked) return std::nullopt;
  objects.write(key, objectSuffix, *linked);
  objects.write(key, digestSuffix, digestOfBytes(*linked));
  return objects.file(key, objectSuffix);
}

}  // namespace muelle::grader
