#include "grader/worker/filter_at_load.h"

#include <link.h>
#include <sys/mman.h>
#include <unistd.h>
#include <array>
#include <cstdint>
#include <cstring>
#include <stdexcept>

namespace muelle::grader::worker {

namespace {

void (*theAction)() = nullptr;
bool called = false;

/// Runs instead of the loader's empty function: before a change of the list of objects, and after it.
void onChange() {
  if (called || _r_debug.r_state != r_debug::RT_CONSISTENT) return;
  called = true;
  theAction();
}

constexpr std::size_t jumpSize = 12;

/// movabs $target, %rax; jmp *%rax
std::array<unsigned char, jumpSize> jumpTo(std::uintptr_t target) {
  std::array<unsigned char, jumpSize> code{0x48, 0xb8, 0, 0, 0, 0, 0, 0, 0, 0, 0xff, 0xe0};
  std::memcpy(code.data() + 2, &target, sizeof target);
  return code;
}

/// "ret", perhaps after "endbr64", in a block of 16 bytes of its own.
bool isEmptyFunction(std::uintptr_t address) {
  constexpr std::array<unsigned char, 5> marked{0xf3, 0x0f, 0x1e, 0xfa, 0xc3};
  const auto* code = reinterpret_cast<const unsigned char*>(address);
  return address % 16 == 0 && (code[0] == 0xc3 || std::memcmp(code, marked.data(), marked.size()) == 0);
}

}  // namespace

void callWhenMapped(void (*action)()) {
  const std::uintptr_t address = _r_debug.r_brk;
  if (address == 0 || !isEmptyFunction(address)) {
    throw std::runtime_error("the dynamic loader offers no place to stop between mapping a file and running it");
  }
  theAction = action;
  const auto pageSize = static_cast<std::uintptr_t>(sysconf(_SC_PAGESIZE));
  auto* page = reinterpret_cast<void*>(address / pageSize * pageSize);
  if (mprotect(page, pageSize, PROT_READ | PROT_WRITE | PROT_EXEC) != 0) {
    throw std::runtime_error("the dynamic loader's code cannot be changed");
  }
  const auto jump = jumpTo(reinterpret_cast<std::uintptr_t>(&onChange));
  std::memcpy(reinterpret_cast<void*>(address), jump.data(), jump.size());
  mprotect(page, pageSize, PROT_READ | PROT_EXEC);
}

bool mappedActionCalled() { return called; }

}  // namespace muelle::grader::worker
