#include "small_disk.h"

#include <fcntl.h>
#include <sched.h>
#include <sys/mount.h>
#include <sys/statvfs.h>

#include "base/process/descriptor.h"

#include <algorithm>
#include <string>

namespace muelle::grader {

namespace {

constexpr const char* filler = "filler";

}  // namespace

SmallDisk::SmallDisk(const std::filesystem::path& folder, std::size_t bytes) : folder_(folder) {
  if (unshare(CLONE_NEWNS) != 0) return;
  if (mount("none", "/", nullptr, MS_REC | MS_PRIVATE, nullptr) != 0) return;
  const std::string size = "size=" + std::to_string(bytes);
  isMounted_ = mount("tmpfs", folder_.c_str(), "tmpfs", 0, size.c_str()) == 0;
}

SmallDisk::~SmallDisk() {
  if (isMounted_) umount2(folder_.c_str(), MNT_DETACH);
}

void SmallDisk::fill(std::size_t left) const {
  struct statvfs disk {};
  if (statvfs(folder_.c_str(), &disk) != 0) return;
  const std::size_t free = disk.f_bavail * disk.f_bsize;
  const Descriptor file(open((folder_ / filler).c_str(), O_CREAT | O_WRONLY | O_CLOEXEC, 0600));
  static_cast<void>(posix_fallocate(file.get(), 0, static_cast<off_t>(free - std::min(free, left))));
}

void SmallDisk::empty() const { std::filesystem::remove(folder_ / filler); }

}  // namespace muelle::grader
