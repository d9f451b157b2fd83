#include "grader/worker/filter.h"

#include <seccomp.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <unistd.h>
#include <array>
#include <cerrno>
#include <memory>
#include <stdexcept>

namespace muelle::grader::worker {

namespace {

/// Arithmetic, memory, the message pipes, and an orderly or violent end.
constexpr std::array runningCalls = {
    SCMP_SYS(read),         SCMP_SYS(write),         SCMP_SYS(brk),          SCMP_SYS(munmap),
    SCMP_SYS(mremap),       SCMP_SYS(madvise),       SCMP_SYS(futex),        SCMP_SYS(exit_group),
    SCMP_SYS(exit),         SCMP_SYS(getpid),        SCMP_SYS(gettid),       SCMP_SYS(rt_sigprocmask),
    SCMP_SYS(rt_sigreturn), SCMP_SYS(clock_gettime), SCMP_SYS(gettimeofday), SCMP_SYS(time),
    SCMP_SYS(getrandom),    SCMP_SYS(fstat),         SCMP_SYS(newfstatat),   SCMP_SYS(restart_syscall),
    SCMP_SYS(sched_yield),
};

/// What the dynamic loader adds while it loads a shared object.
constexpr std::array loadingCalls = {
    SCMP_SYS(openat), SCMP_SYS(close), SCMP_SYS(pread64), SCMP_SYS(lseek), SCMP_SYS(seccomp),
};

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

  void add(std::uint32_t action, int call, const scmp_arg_cmp& condition) {
    check(seccomp_rule_add(context_.get(), action, call, 1, condition));
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

/// Signals go to this process only (abort() raises one), memory is never executable after loading.
void addGuardedCalls(Filter& filter, bool executableMemory) {
  const auto self = static_cast<scmp_datum_t>(getpid());
  filter.add(SCMP_ACT_ALLOW, SCMP_SYS(tgkill), SCMP_A0(SCMP_CMP_EQ, self));
  for (const int call : {SCMP_SYS(mmap), SCMP_SYS(mprotect)}) {
    const scmp_datum_t mask = executableMemory ? 0 : PROT_EXEC;
    filter.add(SCMP_ACT_ALLOW, call, SCMP_A2(SCMP_CMP_MASKED_EQ, mask, 0));
  }
}

}  // namespace

void installLoadingFilter() {
  Filter filter(SCMP_ACT_KILL_PROCESS);
  filter.add(SCMP_ACT_ALLOW, runningCalls);
  filter.add(SCMP_ACT_ALLOW, loadingCalls);
  addGuardedCalls(filter, true);
  // Loading the second filter says so once more; no other attribute of the process may change, its death signal least.
  filter.add(SCMP_ACT_ALLOW, SCMP_SYS(prctl), SCMP_A0(SCMP_CMP_EQ, PR_SET_NO_NEW_PRIVS));
  for (const int call : namedCalls) {
    if (call == SCMP_SYS(openat) || call == SCMP_SYS(close)) continue;
    filter.add(SCMP_ACT_TRAP, std::array{call});
  }
  filter.load();
}

void installRunningFilter() {
  Filter filter(SCMP_ACT_KILL_PROCESS);
  filter.add(SCMP_ACT_ALLOW, runningCalls);
  addGuardedCalls(filter, false);
  filter.add(SCMP_ACT_TRAP, namedCalls);
  filter.load();
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
