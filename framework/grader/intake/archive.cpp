#include "grader/intake/archive.h"

#include "base/text/printable.h"
#include "grader/intake/read_file.h"

#include <archive.h>
#include <archive_entry.h>
#include <fmt/format.h>
#include <locale.h>
#include <algorithm>
#include <array>
#include <memory>
#include <stdexcept>
#include <string_view>

namespace muelle::grader {

namespace {

constexpr std::size_t maximalDepth = 64;

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

/// The compression by the file's first bytes; ARCHIVE_FILTER_NONE when there is none.
int compressionOf(std::string_view bytes) {
  if (bytes.starts_with("\x1f\x8b")) return ARCHIVE_FILTER_GZIP;
  if (bytes.starts_with("BZh")) return ARCHIVE_FILTER_BZIP2;
  if (bytes.starts_with(std::string_view("\xfd"
                                         "7zXZ\0",
                                         6)))
    return ARCHIVE_FILTER_XZ;
  if (bytes.starts_with("\x28\xb5\x2f\xfd")) return ARCHIVE_FILTER_ZSTD;
  return ARCHIVE_FILTER_NONE;
}

class Reader {
 public:
  Reader(const std::string& bytes, const std::string& name, Collector& collector)
      : name_(name), collector_(collector), archive_(::archive_read_new(), ::archive_read_free) {
    if (!archive_) throw std::bad_alloc();
    chooseFormat(compressionOf(bytes));
    if (::archive_read_open_memory(archive_.get(), bytes.data(), bytes.size()) != ARCHIVE_OK) fail();
  }

  void run() {
    std::size_t entries = 0;
    for (;;) {
      archive_entry* entry = nullptr;
      const int status = ::archive_read_next_header(archive_.get(), &entry);
      if (status == ARCHIVE_EOF) break;
      if (status != ARCHIVE_OK && status != ARCHIVE_WARN) fail();
      if (++entries > collector_.limits().entries) {
        collector_.note(fmt::format("only the first {} entries were looked at: hand in the exercises alone",
                                    collector_.limits().entries));
        return;
      }
      visit(entry);
    }
    if (entries == 0) collector_.note("the archive is empty");
  }

 private:
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

  [[noreturn]] void fail() const {
    const char* reason = ::archive_error_string(archive_.get());
    throw std::runtime_error(
        fmt::format("cannot read the archive {}: {}; hand in a folder, or a zip, tar or 7z archive made again", name_,
                    reason == nullptr ? "it is broken" : cut(printableLine(reason), 200)));
  }

  void visit(archive_entry* entry) {
    if (::archive_entry_is_encrypted(entry) != 0)
      throw std::runtime_error(fmt::format("the archive {} is encrypted: make it again without a password", name_));
    const char* raw = ::archive_entry_pathname(entry);
    if (raw == nullptr) raw = ::archive_entry_pathname_utf8(entry);
    RelativePath path;
    const std::string trouble = raw == nullptr ? "its name cannot be read" : split(raw, path);
    if (!trouble.empty()) {
      collector_.note(
          fmt::format("ignored {}: {}", raw == nullptr ? "an entry" : cut(printableLine(raw), 80), trouble));
      return skip();
    }
    offer(entry, path);
  }

  static std::string split(std::string_view name, RelativePath& path) {
    if (name.starts_with('/')) return "an absolute path";
    while (!name.empty()) {
      const std::size_t slash = std::min(name.find('/'), name.size());
      const std::string_view component = name.substr(0, slash);
      name.remove_prefix(std::min(slash + 1, name.size()));
      if (component == "..") return "it leads out of the submission";
      if (!component.empty() && component != ".") path.emplace_back(component);
      if (path.size() > maximalDepth) return "too deep";
    }
    return "";
  }

  void offer(archive_entry* entry, const RelativePath& path) {
    const auto type = ::archive_entry_filetype(entry);
    if (path.empty() || type == AE_IFDIR) return skip();
    if (::archive_entry_hardlink(entry) != nullptr) return refuse(path, "is a hard link");
    if (type == AE_IFLNK || ::archive_entry_symlink(entry) != nullptr) return refuse(path, "is a symbolic link");
    if (type == AE_IFIFO) return refuse(path, "is a named pipe");
    if (type == AE_IFCHR || type == AE_IFBLK) return refuse(path, "is a device");
    if (type != AE_IFREG) return refuse(path, "is no regular file");
    bool wanted = false;
    collector_.file(path, [&] {
      wanted = true;
      return read();
    });
    if (!wanted) skip();
  }

  void refuse(const RelativePath& path, const std::string& why) {
    collector_.notAFile(path, why);
    skip();
  }

  Content read() {
    const std::size_t limit = collector_.limits().sourceBytes;
    std::string text;
    unpack([&](std::string_view piece) {
      if (text.size() <= limit) text += piece;
    });
    if (text.size() > limit) return {"", fmt::format("is larger than {}", showBytes(limit))};
    return {std::move(text), ""};
  }

  /// What does not count is unpacked too, so that the limit holds for it; a plain skip would inflate without end.
  void skip() {
    unpack([](std::string_view) {});
  }

  template <class Use>
  void unpack(Use use) {
    std::array<char, 64 * 1024> buffer;
    for (;;) {
      const la_ssize_t got = ::archive_read_data(archive_.get(), buffer.data(), buffer.size());
      if (got == 0) return;
      if (got < 0 && got != ARCHIVE_WARN) fail();
      const auto size = got > 0 ? static_cast<std::size_t>(got) : 0;
      unpacked_ += size;
      if (unpacked_ > collector_.limits().archiveBytes)
        throw std::runtime_error(fmt::format("the archive {} unpacks to more than {}: hand in the sources alone", name_,
                                             showBytes(collector_.limits().archiveBytes)));
      use(std::string_view(buffer.data(), size));
    }
  }

  const std::string& name_;
  Collector& collector_;
  std::unique_ptr<archive, int (*)(archive*)> archive_;
  std::size_t unpacked_ = 0;
};

}  // namespace

void readArchive(const std::string& bytes, const std::string& name, Collector& collector) {
  const Utf8Names locale;
  Reader(bytes, name, collector).run();
}

}  // namespace muelle::grader
