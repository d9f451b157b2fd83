#include "grader/worker/filter.h"

#include "grader/worker/argument_rule.h"
#include "grader/worker/sanitised.h"

#include <fcntl.h>
#include <seccomp.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <unistd.h>
#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <memory>
#include <stdexcept>
#include <vector>

namespace muelle::grader::worker {

namespace {

/// Arithmetic, memory, the message pipes, and an orderly or violent end.
constexpr std::array runningCalls = {
    SCMP_SYS(read),          SCMP_SYS(write),        SCMP_SYS(brk),        SCMP_SYS(munmap),
    SCMP_SYS(mremap),        SCMP_SYS(madvise),      SCMP_SYS(futex),      SCMP_SYS(getpid),
    SCMP_SYS(gettid),        SCMP_SYS(gettimeofday), SCMP_SYS(time),       SCMP_SYS(getrandom),
    SCMP_SYS(clock_gettime), SCMP_SYS(fstat),        SCMP_SYS(newfstatat), SCMP_SYS(restart_syscall),
    SCMP_SYS(sched_yield),   SCMP_SYS(writev),  // the C library's last words about a broken heap
};

/// What the dynamic loader adds while it maps a shared object, and the second filter.
constexpr std::array loadingCalls = {
    SCMP_SYS(close),
    SCMP_SYS(pread64),
    SCMP_SYS(lseek),
    SCMP_SYS(seccomp),
};

/// What AddressSanitizer adds while a program runs: it looks at its limits and signal stack.
constexpr std::array sanitiserCalls = {SCMP_SYS(sigaltstack), SCMP_SYS(getrlimit)};

/// A call that nobody needs, answered by the running filter with an error of its own: the proof that it stands.
constexpr int probeCall = SCMP_SYS(getpgrp);
constexpr int probeAnswer = EXFULL;

/// What a program without bad intentions may try; named in the message.
constexpr std::array namedCalls = {
    SCMP_SYS(open),
    SCMP_SYS(openat),
    SCMP_SYS(creat),
    SCMP_SYS(close),
    SCMP_SYS(socket),
    SCMP_SYS(clone),
    SCMP_SYS(clone3),
    SCMP_SYS(fork),
    SCMP_SYS(vfork),
    SCMP_SYS(execve),
    SCMP_SYS(kill),
    SCMP_SYS(nanosleep),
    SCMP_SYS(clock_nanosleep),
    SCMP_SYS(pause),
    SCMP_SYS(rt_sigaction),
    SCMP_SYS(ioctl),
    SCMP_SYS(unlink),
    SCMP_SYS(prlimit64),
    SCMP_SYS(setrlimit),
    SCMP_SYS(ptrace),
    SCMP_SYS(poll),
    SCMP_SYS(select),
    SCMP_SYS(getppid),
    SCMP_SYS(readlink),
    SCMP_SYS(pipe2),
    SCMP_SYS(truncate),
    SCMP_SYS(ftruncate),
    SCMP_SYS(unlinkat),
    SCMP_SYS(rename),
    SCMP_SYS(renameat),
    SCMP_SYS(renameat2),
    SCMP_SYS(chmod),
    SCMP_SYS(fchmod),
    SCMP_SYS(fchmodat),
    SCMP_SYS(mkdir),
    SCMP_SYS(mkdirat),
    SCMP_SYS(link),
    SCMP_SYS(symlink),
    SCMP_SYS(seccomp),
    SCMP_SYS(prctl),
};

/// A libseccomp filter, freed with its owner.
class Filter {
 public:
  explicit Filter(std::uint32_t otherwise) : context_(seccomp_init(otherwise), &seccomp_release) {
    if (!context_) throw std::runtime_error("libseccomp could not start a filter");
  }

  template <std::size_t N>
  void add(std::uint32_t action, const std::array<int, N>& calls) {
    for (const int call : calls) check(seccomp_rule_add(context_.get(), action, call, 0));
  }

  /// Every condition must hold. \param conditions on different arguments
  void add(std::uint32_t action, int call, const std::vector<scmp_arg_cmp>& conditions) {
    check(seccomp_rule_add_array(context_.get(), action, call, static_cast<unsigned>(conditions.size()),
                                 conditions.data()));
  }

  /// Raises SIGSYS for named calls. \param except those with rules of their own, which a rule for all arguments
  /// would replace
  void addTraps(const std::vector<int>& except) {
    for (const int call : namedCalls) {
      if (std::find(except.begin(), except.end(), call) == except.end()) add(SCMP_ACT_TRAP, std::array{call});
    }
  }

  void load() { check(seccomp_load(context_.get())); }

 private:
  static void check(int result) {
    // A rule that the default action makes superfluous is refused with EACCES; it changes nothing.
    if (result != 0 && result != -EACCES && result != -EEXIST) {
      throw std::runtime_error("libseccomp refused a rule of the worker's filter");
    }
  }

  std::unique_ptr<void, decltype(&seccomp_release)> context_;
};

/// The one signal that a process may send to itself is abort()'s: no submission can look as if the machine had killed
/// it. No signal can be put off, SIGXCPU least: changing the mask does nothing, and the handlers never return.
void addSignals(Filter& filter) {
  const auto self = static_cast<scmp_datum_t>(getpid());
  filter.add(SCMP_ACT_ALLOW, SCMP_SYS(tgkill), {argumentIs(0, self), argumentIs(2, SIGABRT)});
  filter.add(SCMP_ACT_ERRNO(0), std::array{SCMP_SYS(rt_sigprocmask)});
}

/// A sandbox passes a signal on as the exit status 128 + signal, so no such status may be chosen; exit(-1) may.
void addEnds(Filter& filter) {
  for (const int call : {SCMP_SYS(exit_group), SCMP_SYS(exit)}) {
    filter.add(SCMP_ACT_ALLOW, call, {argumentHas(0, 0x80, 0)});
    filter.add(SCMP_ACT_ALLOW, call, {argumentHas(0, 0xff, 0xff)});
  }
}

/// Memory is never executable once a submission runs.
void addMemory(Filter& filter, bool executable) {
  for (const int call : {SCMP_SYS(mmap), SCMP_SYS(mprotect)}) {
    const scmp_datum_t mask = executable ? 0 : PROT_EXEC;
    filter.add(SCMP_ACT_ALLOW, call, {argumentHas(2, mask, 0)});
  }
}

/// What both filters hold.
void addCommonRules(Filter& filter, bool executableMemory) {
  filter.add(SCMP_ACT_ALLOW, runningCalls);
  if (isSanitised) filter.add(SCMP_ACT_ALLOW, sanitiserCalls);
  addSignals(filter);
  addEnds(filter);
  addMemory(filter, executableMemory);
}

std::unique_ptr<Filter> makeRunningFilter() {
  auto filter = std::make_unique<Filter>(SCMP_ACT_KILL_PROCESS);
  addCommonRules(*filter, false);
  filter->add(SCMP_ACT_ERRNO(probeAnswer), std::array{probeCall});
  filter->addTraps({});
  return filter;
}

std::unique_ptr<Filter>& runningFilter() {
  static std::unique_ptr<Filter> filter;
  return filter;
}

}  // namespace

void installLoadingFilter() {
  runningFilter() = makeRunningFilter();
  Filter filter(SCMP_ACT_KILL_PROCESS);
  addCommonRules(filter, true);
  filter.add(SCMP_ACT_ALLOW, loadingCalls);
  filter.add(SCMP_ACT_ALLOW, std::array{probeCall});
  // The loader only reads: nothing outside can be made, cut or changed even where no sandbox stands around.
  constexpr scmp_datum_t writing = O_ACCMODE | O_CREAT | O_TRUNC | O_APPEND | (O_TMPFILE & ~O_DIRECTORY);
  filter.add(SCMP_ACT_ALLOW, SCMP_SYS(openat), {argumentHas(2, writing, 0)});
  // Loading the second filter says so once more; no other attribute of the process may change, its death signal least.
  filter.add(SCMP_ACT_ALLOW, SCMP_SYS(prctl), {argumentIs(0, PR_SET_NO_NEW_PRIVS)});
  filter.addTraps({SCMP_SYS(openat), SCMP_SYS(close), SCMP_SYS(seccomp), SCMP_SYS(prctl)});
  filter.load();
}

void installRunningFilter() {
  runningFilter()->load();
  errno = 0;
  if (syscall(probeCall) != -1 || errno != probeAnswer) {
    throw std::runtime_error("the worker's second filter of system calls does not hold");
  }
}

const char* systemCallName(int number) {
  // Signal handlers may not allocate, so the names are looked up once, before any handler can run.
  static const auto names = [] {
    std::array<const char*, 512> table{};
    for (const int call : namedCalls) {
      if (call >= 0 && call < static_cast<int>(table.size())) {
        table[static_cast<std::size_t>(call)] = seccomp_syscall_resolve_num_arch(SCMP_ARCH_NATIVE, call);
      }
    }
    return table;
  }();
  if (number < 0 || number >= static_cast<int>(names.size())) return "a system call";
  const char* name = names[static_cast<std::size_t>(number)];
  return name != nullptr ? name : "a system call";
}

}  // namespace muelle::grader::worker
