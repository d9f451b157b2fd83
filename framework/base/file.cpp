#include "base/file.h"

#include <fmt/format.h>
#include <unistd.h>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
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
  if (fs::is_directory(file)) fail("read", file, std::strerror(EISDIR));
  errno = 0;
  std::ifstream in(file, std::ios::binary);
  if (!in) fail("read", file, std::strerror(errno));
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
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
