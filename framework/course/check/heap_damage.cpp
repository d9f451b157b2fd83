#include "course/check/heap_damage.h"

#include "base/text/printable.h"

#include <fmt/format.h>
#include <algorithm>
#include <array>

namespace muelle {

namespace {

/// How the C library's last words begin. It writes them as a line of their own.
constexpr auto lastWords = std::to_array<std::string_view>(
    {"free(): ", "malloc(): ", "realloc(): ", "munmap_chunk(): ", "malloc_consolidate(): ", "double free or corruption",
     "corrupted ", "break adjusted to free malloc space"});

}  // namespace

std::string heapDamage(std::string_view output) {
  while (output.ends_with('\n')) output.remove_suffix(1);
  const std::size_t newline = output.rfind('\n');
  const std::string_view line = newline == std::string_view::npos ? output : output.substr(newline + 1);
  const bool isTheirs = std::ranges::any_of(lastWords, [&](std::string_view start) { return line.starts_with(start); });
  if (!isTheirs) return "";
  return fmt::format(
      "damaged the heap: something was written beyond the end of an array or a vector, or given back twice ({})",
      printableLine(line.substr(0, 100)));
}

}  // namespace muelle
