#pragma once
#include <cstddef>
#include <optional>
#include <string>

namespace muelle::grader {

/// All that the open file holds; nullopt when that is more than `limit` bytes. The size is what was read, not what
/// the file system says. Throws std::system_error when reading fails.
std::optional<std::string> readAll(int fd, std::size_t limit);

/// "256 KiB", "32 MiB".
std::string showBytes(std::size_t bytes);

}  // namespace muelle::grader
