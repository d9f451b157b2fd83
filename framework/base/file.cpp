#include "base/file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>
#include <array>
#include <cerrno>
#include <random>
#include <stdexcept>
#include <system_error>

namespace muelle {

namespace fs = std::filesystem;

namespace {

/// "cannot read FILE: REASON", with the reason's number for whoever must know whose fault it is.
[[noreturn]] void fail(const char* action, const fs::path& path, std::error_code reason) {
  throw std::system_error(reason, fmt::format("cannot {} {}", action, path.string()));
}

std::error_code ofSystem(int number) { return {number, std::generic_category()}; }

constexpr const char* folderStem = "work";
constexpr const char* temporarySuffix = ".tmp";

/// Drawn at random: a number of a process is another's in the next container, and a dead one's later.
std::string temporaryName(const std::string& stem) {
  std::random_device device;
  return fmt::format(".{}.{:08x}{:08x}{}", stem, device(), device(), temporarySuffix);
}

/// The system's error number, or 0.
int writeWhole(int descriptor, std::string_view text) {
  while (!text.empty()) {
    const ssize_t count = ::write(descriptor, text.data(), text.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return errno;
    text.remove_prefix(static_cast<std::size_t>(count));
  }
  return 0;
}

/// The system's error number, or 0.
int writeNew(const fs::path& file, std::string_view text, Durable durable) {
  Descriptor descriptor(::open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
  if (!descriptor) return errno;
  if (const int error = writeWhole(descriptor.get(), text); error != 0) return error;
  if (durable == Durable::Yes && ::fsync(descriptor.get()) != 0) return errno;
  // A disk on the network says only at a close that it is full.
  const int same = ::dup(descriptor.get());
  return same >= 0 && ::close(same) != 0 ? errno : 0;
}

/// A lock of the folder, which its owner has until it ends, however it ends; none when another has it.
Descriptor lockOf(const fs::path& folder) {
  Descriptor descriptor(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC));
  if (descriptor && ::flock(descriptor.get(), LOCK_EX | LOCK_NB) != 0) descriptor.reset();
  return descriptor;
}

/// The file's bytes at the end of `text`; the system's error number when it cannot be read to its end, else 0.
int readWhole(const fs::path& file, std::string& text) {
  const Descriptor descriptor(::open(file.c_str(), O_RDONLY | O_CLOEXEC));
  if (descriptor.get() < 0) return errno;
  std::array<char, 65536> buffer;
  for (;;) {
    const ssize_t got = ::read(descriptor.get(), buffer.data(), buffer.size());
    if (got == 0) return 0;
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return errno;
    text.append(buffer.data(), static_cast<std::size_t>(got));
  }
}

}  // namespace

void writeFile(const fs::path& file, std::string_view text, Durable durable) {
  const fs::path temporary = file.parent_path() / temporaryName(file.filename().string());
  std::error_code error;
  if (const int number = writeNew(temporary, text, durable); number != 0) {
    fs::remove(temporary, error);
    fail("write", file, ofSystem(number));
  }
  fs::rename(temporary, file, error);
  if (error) {
    std::error_code ignored;
    fs::remove(temporary, ignored);
    fail("write", file, error);
  }
}

std::string readFile(const fs::path& file) {
  std::string text;
  const int error = readWhole(file, text);
  if (error != 0) fail("read", file, ofSystem(error));
  return text;
}

std::optional<std::string> tryReadFile(const fs::path& file) {
  std::string text;
  if (readWhole(file, text) != 0) return std::nullopt;
  return text;
}

TemporaryFolder::TemporaryFolder(const fs::path& parent) : path_(parent / temporaryName(folderStem)) {
  std::error_code error;
  fs::create_directories(parent, error);
  const bool isNew = !error && fs::create_directory(path_, error);
  if (error) fail("make the folder", path_, error);
  if (!isNew) fail("make the folder", path_, ofSystem(EEXIST));
  alive_ = lockOf(path_);
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

void removeAbandonedFolders(const fs::path& parent, std::chrono::seconds age) {
  std::error_code error;
  for (fs::directory_iterator entry(parent, error), end; !error && entry != end; entry.increment(error)) {
    const std::string name = entry->path().filename();
    if (!name.starts_with(fmt::format(".{}.", folderStem)) || !name.ends_with(temporarySuffix)) continue;
    std::error_code gone;
    // Its owner makes it a moment before it locks it.
    const bool isOld = fs::file_time_type::clock::now() - entry->last_write_time(gone) >= age;
    if (!gone && isOld && lockOf(entry->path())) fs::remove_all(entry->path(), gone);
  }
}

}  // namespace muelle
