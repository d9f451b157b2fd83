#include "grader/intake/archive.h"

#include "base/text/printable.h"
#include "grader/intake/gzip_checksum.h"
#include "grader/intake/package.h"
#include "grader/intake/read_file.h"

#include <archive.h>
#include <archive_entry.h>
#include <fmt/format.h>
#include <locale.h>
#include <algorithm>
#include <array>
#include <map>
#include <memory>
#include <stdexcept>
#include <string_view>

namespace muelle::grader {

namespace {

constexpr std::size_t maximalArchiveDepth = 64;
constexpr int maximalOpen = 2;  ///< an archive in an archive

/// libarchive converts names to the locale's character set; without this a folder named "José" has none in the C
/// locale.
class Utf8Names {
 public:
  Utf8Names() : utf8_(::newlocale(LC_CTYPE_MASK, "C.UTF-8", nullptr)) {
    if (utf8_ != nullptr) before_ = ::uselocale(utf8_);
  }
  Utf8Names(const Utf8Names&) = delete;
  Utf8Names& operator=(const Utf8Names&) = delete;
  ~Utf8Names() {
    if (utf8_ == nullptr) return;
    ::uselocale(before_);
    ::freelocale(utf8_);
  }

 private:
  locale_t utf8_;
  locale_t before_{};
};

/// One archive while it is read.
class OpenArchive {
 public:
  OpenArchive(const std::string& bytes, const std::string& name, const RelativePath& folder, ArchiveReader& reader)
      : bytes_(bytes),
        name_(name),
        folder_(folder),
        reader_(reader),
        collector_(reader.collector()),
        archive_(::archive_read_new(), ::archive_read_free) {
    if (!archive_) throw std::bad_alloc();
    checkGzip();
    chooseFormat(compressionOf(bytes));
    if (::archive_read_open_memory(archive_.get(), bytes.data(), bytes.size()) != ARCHIVE_OK) fail();
  }

  void run() {
    bool isEmpty = true;
    for (;;) {
      archive_entry* entry = nullptr;
      const int status = ::archive_read_next_header(archive_.get(), &entry);
      if (status == ARCHIVE_EOF) break;
      if (status != ARCHIVE_OK && (status != ARCHIVE_WARN || isInconsistent())) fail();
      if (!reader_.countEntry()) return;
      isEmpty = false;
      visit(entry);
    }
    if (isEmpty) collector_.note(fmt::format("the archive {} is empty", name_));
  }

 private:
  /// A warning about a header that says two things; the others (a name in an unknown character set) do no harm.
  bool isInconsistent() const {
    const char* reason = ::archive_error_string(archive_.get());
    return reason != nullptr && std::string_view(reason).starts_with("Inconsistent");
  }

  /// Only what is needed, by name: other formats of libarchive read further files (mtree) or start programs (lrzip).
  /// One compression at most, since a bomb can be nested.
  void chooseFormat(int compression) {
    ::archive_read_support_format_tar(archive_.get());
    if (compression == ARCHIVE_FILTER_NONE) {
      ::archive_read_support_format_zip_seekable(archive_.get());
      ::archive_read_support_format_7zip(archive_.get());
    } else if (::archive_read_append_filter(archive_.get(), compression) != ARCHIVE_OK) {
      fail();
    }
  }

  void checkGzip() const {
    if (compressionOf(bytes_) != ARCHIVE_FILTER_GZIP) return;
    // More than the limit of what is in the files: a tar archive has headers too.
    const std::string fault = gzipFault(bytes_, 2 * collector_.limits().archiveBytes);
    if (!fault.empty()) fail(fault);
  }

  [[noreturn]] void fail() const {
    const char* reason = ::archive_error_string(archive_.get());
    fail(reason == nullptr ? "it is broken" : cut(printableLine(reason), 200));
  }

  [[noreturn]] void fail(const std::string& reason) const {
    throw std::runtime_error(fmt::format(
        "cannot read the archive {}: {}; hand in a folder, or a zip, tar or 7z archive made again", name_, reason));
  }

  void visit(archive_entry* entry) {
    if (::archive_entry_is_encrypted(entry) != 0)
      throw std::runtime_error(fmt::format("the archive {} is encrypted: make it again without a password", name_));
    const char* raw = ::archive_entry_pathname(entry);
    if (raw == nullptr) raw = ::archive_entry_pathname_utf8(entry);
    RelativePath path = folder_;
    const std::string trouble = raw == nullptr ? "its name cannot be read" : split(raw, path);
    if (!trouble.empty()) {
      collector_.skipped(raw == nullptr ? "" : lastOf(raw),
                         fmt::format("ignored {}: {}; make the archive again, of the folder with the exercises",
                                     raw == nullptr ? "an entry" : cut(printableLine(raw), 80), trouble));
      return skip();
    }
    offer(entry, path);
  }

  static std::string lastOf(std::string_view name) { return std::string(name.substr(name.find_last_of("/\\") + 1)); }

  static std::string split(std::string_view name, RelativePath& path) {
    // Some programs for Windows write "spring_1d\\spring_1d.cpp".
    const char separator = name.find('/') == std::string_view::npos ? '\\' : '/';
    if (name.starts_with(separator)) return "an absolute path";
    while (!name.empty()) {
      const std::size_t slash = std::min(name.find(separator), name.size());
      const std::string_view component = name.substr(0, slash);
      name.remove_prefix(std::min(slash + 1, name.size()));
      if (component == "..") return "it leads out of the submission";
      if (!component.empty() && component != ".") path.emplace_back(component);
      if (path.size() > maximalArchiveDepth) return "too deep";
    }
    return "";
  }

  void offer(archive_entry* entry, const RelativePath& path) {
    const auto type = ::archive_entry_filetype(entry);
    if (path.size() == folder_.size() || type == AE_IFDIR) return skip();
    if (const char* target = ::archive_entry_hardlink(entry)) return offerAgain(target, path);
    if (type == AE_IFLNK || ::archive_entry_symlink(entry) != nullptr) return refuse(path, "is a symbolic link");
    if (type == AE_IFIFO) return refuse(path, "is a named pipe");
    if (type == AE_IFCHR || type == AE_IFBLK) return refuse(path, "is a device");
    if (type != AE_IFREG) return refuse(path, "is no regular file");
    reader_.sawFile(path);
    std::string head;
    std::string bytes;
    const bool isAnArchive = read(path, head, bytes);
    if (isAnArchive) return reader_.readInside(bytes, path);
    collector_.regularFile(path, head, [&] { return collector_.contentOf(bytes); });
    // A tar archive may say later that another name has the same bytes.
    if ((::archive_format(archive_.get()) & ARCHIVE_FORMAT_BASE_MASK) == ARCHIVE_FORMAT_TAR)
      texts_[path] = std::move(bytes);
  }

  /// A hard link in an archive is a second name of what the archive holds. Outside of it nothing is looked for.
  void offerAgain(const char* target, const RelativePath& path) {
    RelativePath first = folder_;
    const std::string trouble = split(target, first);
    const auto text = texts_.find(first);
    if (!trouble.empty() || text == texts_.end())
      return refuse(path, "is a hard link to what the archive does not hold: hand in the file itself");
    skip();
    const std::string bytes = text->second;
    collector_.regularFile(path, bytes.substr(0, headBytes), [&] { return collector_.contentOf(bytes); });
    texts_[path] = bytes;
  }

  /// Unpacks an entry, whole when it is an archive, else a little more of it than a source may have: what does not
  /// count is unpacked too, so that the limits hold for it and its checksum is compared. True when it is an archive.
  bool read(const RelativePath& path, std::string& head, std::string& bytes) {
    const std::size_t limit = collector_.limits().sourceBytes;
    const bool isHidden = Collector::isHidden(path);
    unpack([&](std::string_view piece) {
      if (head.size() < headBytes) head += piece.substr(0, headBytes - head.size());
      if (bytes.size() <= limit || (!isHidden && isArchive(path.back(), head))) bytes += piece;
    });
    return !isHidden && isArchive(path.back(), head);
  }

  void refuse(const RelativePath& path, const std::string& why) {
    collector_.notAFile(path, why);
    skip();
  }

  /// What does not count is unpacked too, so that the limit holds for it (a plain skip would inflate without end) and
  /// its checksum is compared.
  void skip() {
    unpack([](std::string_view) {});
  }

  template <class Use>
  void unpack(Use use) {
    std::array<char, 64 * 1024> buffer;
    for (;;) {
      const la_ssize_t got = ::archive_read_data(archive_.get(), buffer.data(), buffer.size());
      if (got == 0) return;
      if (got < 0) fail();  // a warning too: of a wrong checksum or size
      const auto size = static_cast<std::size_t>(got);
      reader_.countBytes(size, name_);
      use(std::string_view(buffer.data(), size));
    }
  }

  const std::string& bytes_;
  const std::string& name_;
  const RelativePath& folder_;
  ArchiveReader& reader_;
  Collector& collector_;
  std::map<RelativePath, std::string> texts_;  ///< of a tar archive's files; no more than the limit of unpacked bytes
  std::unique_ptr<archive, int (*)(archive*)> archive_;
};

}  // namespace

void ArchiveReader::open(const std::string& bytes, const std::string& name, const RelativePath& folder) {
  // A zip file that begins with the end of its directory holds nothing; libarchive does not know it for one.
  if (bytes.starts_with("PK\x05\x06")) return collector_.note(fmt::format("the archive {} is empty", name));
  const Utf8Names locale;
  OpenArchive(bytes, name, folder, *this).run();
}

void ArchiveReader::read(const std::string& bytes, const std::string& name) {
  ++opened_;
  open(bytes, name, {});
  --opened_;
}

void ArchiveReader::readInside(const std::string& bytes, const RelativePath& path) {
  if (opened_ == maximalOpen)
    return collector_.skipped(
        "", fmt::format("ignored {}: an archive in an archive is opened, a deeper one is not; hand in the folder",
                        show(path)));
  ++opened_;
  open(bytes, show(path), path);
  --opened_;
}

bool ArchiveReader::countEntry() {
  const std::size_t limit = collector_.limits().entries;
  if (++entries_ == limit + 1)
    collector_.skipped("", fmt::format("only the first {} entries were looked at: hand in the exercises alone", limit));
  return entries_ <= limit;
}

void ArchiveReader::countBytes(std::size_t bytes, const std::string& name) {
  const std::size_t limit = collector_.limits().archiveBytes;
  unpacked_ += bytes;
  if (unpacked_ > limit)
    throw std::runtime_error(
        fmt::format("the archive {} unpacks to more than {}: hand in the sources alone", name, showBytes(limit)));
}

void refuseLargeArchive(const std::string& name, std::size_t limit) {
  throw std::runtime_error(
      fmt::format("the archive {} is larger than {}: hand in the sources alone", name, showBytes(limit)));
}

}  // namespace muelle::grader
