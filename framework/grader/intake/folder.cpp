#include "grader/intake/folder.h"

#include "base/process/descriptor.h"
#include "base/text/printable.h"
#include "grader/intake/archive.h"
#include "grader/intake/file_names.h"
#include "grader/intake/package.h"
#include "grader/intake/read_file.h"

#include <dirent.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>
#include <algorithm>
#include <cerrno>
#include <cstring>
#include <deque>
#include <stdexcept>
#include <system_error>

namespace muelle::grader {

namespace {

constexpr std::size_t maximalDepth = 32;
constexpr int folderFlags = O_RDONLY | O_DIRECTORY | O_CLOEXEC | O_NONBLOCK;

std::string kindOf(mode_t mode) {
  if (S_ISLNK(mode)) return "is a symbolic link";
  if (S_ISFIFO(mode)) return "is a named pipe";
  if (S_ISSOCK(mode)) return "is a socket";
  if (S_ISCHR(mode) || S_ISBLK(mode)) return "is a device";
  if (S_ISDIR(mode)) return "is a folder";
  return "is no regular file";
}

std::string cannotBeRead() { return fmt::format("cannot be read: {}", std::strerror(errno)); }

std::string cannotBeRead(const std::system_error& error) {
  return fmt::format("cannot be read: {}", error.code().message());
}

class Walk {
 public:
  Walk(int root, Collector& collector) : root_(root), collector_(collector), archives_(collector) {}

  void run() {
    while (!pending_.empty() && !full_) {
      const RelativePath folder = pending_.front();
      pending_.pop_front();
      visit(folder);
    }
  }

 private:
  /// Opens a folder from the root, component by component, so that no link on the way is followed.
  Descriptor open(const RelativePath& folder) const {
    Descriptor current(::openat(root_, ".", folderFlags));
    for (const std::string& name : folder) {
      if (!current) break;
      current = Descriptor(::openat(current.get(), name.c_str(), folderFlags | O_NOFOLLOW));
    }
    return current;
  }

  std::vector<std::string> names(const Descriptor& folder, const RelativePath& path) {
    std::vector<std::string> found;
    const int copy = ::openat(folder.get(), ".", folderFlags);  // the stream owns and closes it
    DIR* stream = copy >= 0 ? ::fdopendir(copy) : nullptr;
    if (stream == nullptr) {
      collector_.unreadableFolder(path, cannotBeRead());
      if (copy >= 0) ::close(copy);
      return found;
    }
    for (;;) {
      errno = 0;
      const dirent* entry = ::readdir(stream);
      if (entry == nullptr && errno != 0) collector_.unreadableFolder(path, cannotBeRead());
      if (entry == nullptr) break;
      const std::string name = entry->d_name;
      if (name == "." || name == "..") continue;
      if (!archives_.countEntry()) {
        full_ = true;
        break;
      }
      found.push_back(name);
    }
    ::closedir(stream);
    std::sort(found.begin(), found.end());
    return found;
  }

  void visit(const RelativePath& path) {
    const Descriptor folder = open(path);
    if (!folder) return collector_.unreadableFolder(path, cannotBeRead());
    const std::vector<std::string> found = names(folder, path);
    for (const std::string& name : found) {
      RelativePath entry = path;
      entry.push_back(name);
      offer(folder, entry);
    }
  }

  void offer(const Descriptor& folder, const RelativePath& path) {
    struct stat status {};
    if (::fstatat(folder.get(), path.back().c_str(), &status, AT_SYMLINK_NOFOLLOW) != 0)
      return collector_.file(path, [] { return Content::unreadable(cannotBeRead()); });
    if (S_ISDIR(status.st_mode)) return enter(path);
    if (!S_ISREG(status.st_mode)) return collector_.notAFile(path, kindOf(status.st_mode));
    Content trouble;
    const Descriptor file = openRegular(folder, path.back(), trouble);
    const bool mayHoldAny = isArchiveName(path.back()) && !Collector::isHidden(path);
    if (!file && mayHoldAny && !trouble.fault.empty()) return collector_.unreadableFolder(path, trouble.fault);
    if (!file) return collector_.file(path, [&] { return trouble; });
    const std::string head = headOf(file);
    if (isArchive(path.back(), head) && !Collector::isHidden(path)) return unpack(file, path);
    collector_.regularFile(path, head, [&] { return read(file); });
  }

  static std::string headOf(const Descriptor& file) {
    std::string head(headBytes, '\0');
    const ssize_t got = ::pread(file.get(), head.data(), head.size(), 0);
    head.resize(got > 0 ? static_cast<std::size_t>(got) : 0);
    return head;
  }

  void unpack(const Descriptor& file, const RelativePath& path) {
    const std::size_t limit = collector_.limits().archiveBytes;
    try {
      const std::optional<std::string> bytes = readAll(file.get(), limit);
      if (!bytes) refuseLargeArchive(show(path), limit);
      archives_.readInside(*bytes, path);
    } catch (const std::system_error& error) {
      collector_.unreadableFolder(path, cannotBeRead(error));
    }
  }

  void enter(const RelativePath& path) {
    if (Collector::isHidden(path)) return collector_.notAFile(path, "is hidden");
    if (path.size() > maximalDepth)
      return collector_.skipped("", fmt::format("ignored {}/: too deep; hand in the exercises alone", show(path)));
    pending_.push_back(path);
  }

  /// A hard link is a file like any other, unless somebody put another's file under this name.
  static bool isAnothers(const Descriptor& folder, const struct stat& file) {
    struct stat owner {};
    return file.st_nlink > 1 && (::fstat(folder.get(), &owner) != 0 || owner.st_uid != file.st_uid);
  }

  /// Null with the trouble when it cannot be opened. The name was a regular file a moment ago; O_NONBLOCK and the
  /// second look are for one that changed since.
  static Descriptor openRegular(const Descriptor& folder, const std::string& name, Content& trouble) {
    Descriptor file(::openat(folder.get(), name.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_NOCTTY | O_CLOEXEC));
    struct stat status {};
    if (!file && errno == ELOOP) {
      trouble = Content::refused("is a symbolic link");
    } else if (!file || ::fstat(file.get(), &status) != 0) {
      trouble = Content::unreadable(cannotBeRead());
    } else if (!S_ISREG(status.st_mode)) {
      trouble = Content::refused(kindOf(status.st_mode));
    } else if (isAnothers(folder, status)) {
      trouble = Content::refused("is a hard link to a file of another user: hand in a copy");
    } else {
      return file;
    }
    return Descriptor();
  }

  Content read(const Descriptor& file) const {
    try {
      return collector_.contentOf(readAll(file.get(), collector_.limits().sourceBytes));
    } catch (const std::system_error& error) {
      return Content::unreadable(cannotBeRead(error));
    }
  }

  int root_;
  Collector& collector_;
  std::deque<RelativePath> pending_{RelativePath{}};
  ArchiveReader archives_;
  bool full_ = false;
};

}  // namespace

void readFolder(const std::filesystem::path& folder, Collector& collector) {
  const Descriptor root(::open(folder.c_str(), folderFlags));
  if (!root)
    throw std::runtime_error(fmt::format("cannot read the folder {}: {}; check its permissions",
                                         printableLine(folder.string()), std::strerror(errno)));
  Walk(root.get(), collector).run();
}

}  // namespace muelle::grader
