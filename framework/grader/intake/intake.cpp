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

/// Puts a hand-in's parts before the collector.
class Parts {
 public:
  Parts(Collector& collector, bool areSeveral)
      : collector_(collector), archives_(collector), limit_(collector.limits().archiveBytes), areSeveral_(areSeveral) {}

  void read(const std::filesystem::path& path) {
    const Descriptor file(::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC));
    struct stat status {};
    if (!file || ::fstat(file.get(), &status) != 0)
      throw std::runtime_error(fmt::format("cannot read the submission {}: {}; give a folder or an archive",
                                           printableLine(path.string()), std::strerror(errno)));
    if (S_ISDIR(status.st_mode)) return readFolder(path, collector_);
    if (!S_ISREG(status.st_mode))
      throw std::runtime_error(fmt::format("{} is neither a folder nor an archive", printableLine(path.string())));
    readFile(path, readAll(file.get(), limit_));
  }

  /// The paths in the archive that is the whole hand-in.
  const std::vector<RelativePath>& archived() const { return archives_.files(); }

 private:
  /// An archive, or a source alone when its name says so and its content nothing else.
  void readFile(const std::filesystem::path& path, const std::optional<std::string>& bytes) {
    const std::string fileName = path.filename().string();
    const std::string name = nameOf(path);
    const std::string head = bytes ? bytes->substr(0, headBytes) : "";
    const bool isSource = isSourceName(fileName) && !beginsAsArchive(head);
    if (isSource || (areSeveral_ && !isArchive(fileName, head)))
      return collector_.regularFile({fileName}, head, [&] { return collector_.contentOf(bytes); });
    if (!bytes) refuseLargeArchive(name, limit_);
    // Among several, the archive's own name tells its files from another's.
    if (areSeveral_) return archives_.readInside(*bytes, {fileName});
    if (const std::optional<StandIn> other = standIn(fileName, head))
      throw std::runtime_error(fmt::format("cannot read the archive {}: {}", name, other->why));
    archives_.read(*bytes, name);
  }

  Collector& collector_;
  ArchiveReader archives_;
  std::size_t limit_;
  bool areSeveral_;
};

}  // namespace

Submission takeSubmission(const std::filesystem::path& path, const std::vector<Manifest>& course,
                          const IntakeLimits& limits, const std::vector<std::string>& only,
                          const SourcesByTopic& stubs) {
  return takeSubmission(std::vector{path}, course, limits, only, stubs);
}

Submission takeSubmission(const std::vector<std::filesystem::path>& parts, const std::vector<Manifest>& course,
                          const IntakeLimits& limits, const std::vector<std::string>& only,
                          const SourcesByTopic& stubs) {
  Collector collector(course, limits, only, stubs);
  Parts reading(collector, parts.size() > 1);
  for (const std::filesystem::path& part : parts) reading.read(part);
  Submission submission = collector.finish(nameOf(parts.front()));
  submission.path = std::filesystem::absolute(parts.front());
  submission.archived = reading.archived();
  return submission;
}

}  // namespace muelle::grader
