#pragma once
#include "grader/intake/collector.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace muelle::grader {

/// Reads the archives of one submission (zip, 7z, tar; tar also through one of gzip, bzip2, xz, zstd) in memory and
/// offers their entries to the collector. The limits of entries and of unpacked bytes hold for all of them together.
class ArchiveReader {
 public:
  /// `collector` must outlive this.
  explicit ArchiveReader(Collector& collector) : collector_(collector) {}

  /// The archive that is the submission. `bytes` is the whole file; `name`, printable, is for the messages.
  /// Throws std::runtime_error, one line, when it is no such archive, broken (checksums and sizes are compared for
  /// every entry, wanted or not), encrypted, or unpacks to more than the limit.
  void read(const std::string& bytes, const std::string& name);

  /// An archive that lies in the submission, at `path`. At most two are open at a time, an archive in an archive; a
  /// deeper one is ignored and said so. Throws as read() does: a broken archive is broken wherever it lies, or it would
  /// depend on what else is there whether it counts.
  void readInside(const std::string& bytes, const RelativePath& path);

  /// Counts one more entry of an archive or folder; false, and said once, when that is more than the limit.
  bool countEntry();

  /// Notes a file of the outermost archive.
  void sawFile(const RelativePath& path) {
    if (opened_ == 1) files_.push_back(path);
  }

  /// Counts bytes that were unpacked; throws std::runtime_error when that is more than the limit. `name` as in read().
  void countBytes(std::size_t bytes, const std::string& name);

  Collector& collector() { return collector_; }

  /// The paths of the files in the archive that read() has read; an archive inside counts as a file.
  const std::vector<RelativePath>& files() const { return files_; }

 private:
  void open(const std::string& bytes, const std::string& name, const RelativePath& folder);

  Collector& collector_;
  std::size_t entries_ = 0;
  std::size_t unpacked_ = 0;
  std::vector<RelativePath> files_;
  int opened_ = 0;  ///< archives being read now, one in the other
};

/// Throws the std::runtime_error, one line, of an archive that is larger than `limit` bytes itself.
[[noreturn]] void refuseLargeArchive(const std::string& name, std::size_t limit);

}  // namespace muelle::grader
