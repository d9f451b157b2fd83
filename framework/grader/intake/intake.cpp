#include "grader/intake/intake.h"

#include "base/process/descriptor.h"
#include "base/text/printable.h"
#include "grader/intake/archive.h"
#include "grader/intake/collector.h"
#include "grader/intake/file_names.h"
#include "grader/intake/folder.h"
#include "grader/intake/package.h"
#include "grader/intake/read_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <cerrno>
#include <cstring>
#include <stdexcept>

namespace muelle::grader {

namespace {

constexpr std::size_t nameBytes = 200;

/// The last component that names something: "solutions" for "solutions/" and for "." inside it.
std::string nameOf(const std::filesystem::path& path) {
  std::error_code ignored;
  std::filesystem::path whole = std::filesystem::absolute(path, ignored).lexically_normal();
  if (whole.filename().empty()) whole = whole.parent_path();
  return cut(printableLine(whole.filename().string()), nameBytes);
}

/// An archive, or a source alone when its name says so and its content nothing else.
void readFileOf(const Descriptor& file, const std::filesystem::path& path, const std::string& name,
                Collector& collector) {
  const std::size_t limit = collector.limits().archiveBytes;
  std::optional<std::string> bytes = readAll(file.get(), limit);
  const std::string fileName = path.filename().string();
  if (isSourceName(fileName) && !(bytes && beginsAsArchive(*bytes))) {
    const std::size_t sourceLimit = collector.limits().sourceBytes;
    const bool isTooLarge = !bytes || bytes->size() > sourceLimit;
    return collector.file({fileName}, [&]() -> Content {
      if (isTooLarge) return Content::refused(fmt::format("is larger than {}", showBytes(sourceLimit)));
      return {std::move(*bytes)};
    });
  }
  if (!bytes) refuseLargeArchive(name, limit);
  ArchiveReader(collector).read(*bytes, name);
}

}  // namespace

Submission takeSubmission(const std::filesystem::path& path, const std::vector<Manifest>& course,
                          const IntakeLimits& limits, const std::vector<std::string>& only,
                          const SourcesByTopic& stubs) {
  const std::string name = nameOf(path);
  Collector collector(course, limits, only, stubs);
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC));
  struct stat status {};
  if (!file || ::fstat(file.get(), &status) != 0)
    throw std::runtime_error(fmt::format("cannot read the submission {}: {}; give a folder or an archive",
                                         printableLine(path.string()), std::strerror(errno)));
  if (S_ISDIR(status.st_mode)) {
    readFolder(path, collector);
  } else if (S_ISREG(status.st_mode)) {
    readFileOf(file, path, name, collector);
  } else {
    throw std::runtime_error(fmt::format("{} is neither a folder nor an archive", printableLine(path.string())));
  }
  Submission submission = collector.finish(name);
  submission.path = std::filesystem::absolute(path);
  return submission;
}

}  // namespace muelle::grader
