#include "base/file.h"

#include "base/process/descriptor.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>
#include <array>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <stdexcept>
#include <system_error>

namespace muelle {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void fail(const char* action, const fs::path& path, const std::string& reason) {
  throw std::runtime_error(fmt::format("cannot {} {}: {}", action, path.string(), reason));
}

/// Unique among the processes and threads that write now.
std::string temporaryName(const std::string& stem) {
  static std::atomic<unsigned> counter{0};
  return fmt::format(".{}.{}-{}.tmp", stem, ::getpid(), counter++);
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

void writeFile(const fs::path& file, std::string_view text) {
  const fs::path temporary = file.parent_path() / temporaryName(file.filename().string());
  errno = 0;
  std::ofstream out(temporary, std::ios::binary);
  out.write(text.data(), static_cast<std::streamsize>(text.size()));
  out.close();
  std::error_code error;
  if (!out) {
    const std::string reason = std::strerror(errno);
    fs::remove(temporary, error);
    fail("write", file, reason);
  }
  fs::rename(temporary, file, error);
  if (error) {
    const std::string reason = error.message();
    fs::remove(temporary, error);
    fail("write", file, reason);
  }
}

std::string readFile(const fs::path& file) {
  std::string text;
  const int error = readWhole(file, text);
  if (error != 0) fail("read", file, std::strerror(error));
  return text;
}

std::optional<std::string> tryReadFile(const fs::path& file) {
  std::string text;
  if (readWhole(file, text) != 0) return std::nullopt;
  return text;
}

TemporaryFolder::TemporaryFolder(const fs::path& parent) : path_(parent / temporaryName("work")) {
  std::error_code error;
  fs::create_directories(path_, error);
  if (error) fail("make the folder", path_, error.message());
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

}  // namespace muelle
