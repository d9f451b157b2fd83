/// \file
/// muelle-confine: takes rights away from itself, then becomes another program. Landlock and a filter of system calls
/// hold for everything that comes after; the user id has been changed before, by setpriv.
///
///     muelle-confine [--read PATH]... [--write FOLDER]... -- PROGRAM ARGUMENT...

#include <fcntl.h>
#include <linux/landlock.h>
#include <sched.h>
#include <seccomp.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

// Rights that later versions of Landlock brought; this machine's header may not know them yet.
constexpr std::uint64_t truncateFile = 1ULL << 14;      // version 3
constexpr std::uint64_t deviceControl = 1ULL << 15;     // version 5
constexpr std::uint64_t tcpBindAndConnect = 3;          // version 4
constexpr std::uint64_t signalsAndAbstractSockets = 3;  // version 6

/// struct landlock_ruleset_attr of the latest version; an older kernel is told a shorter size.
struct RulesetAttributes {
  std::uint64_t files = 0;
  std::uint64_t network = 0;
  std::uint64_t scoped = 0;
};

constexpr std::uint64_t readRights =
    LANDLOCK_ACCESS_FS_EXECUTE | LANDLOCK_ACCESS_FS_READ_FILE | LANDLOCK_ACCESS_FS_READ_DIR;
constexpr std::uint64_t writeRights = LANDLOCK_ACCESS_FS_WRITE_FILE | LANDLOCK_ACCESS_FS_READ_FILE |
                                      LANDLOCK_ACCESS_FS_READ_DIR | LANDLOCK_ACCESS_FS_REMOVE_FILE |
                                      LANDLOCK_ACCESS_FS_REMOVE_DIR | LANDLOCK_ACCESS_FS_MAKE_REG |
                                      LANDLOCK_ACCESS_FS_MAKE_DIR | truncateFile;
constexpr std::uint64_t fileOnlyRights = LANDLOCK_ACCESS_FS_EXECUTE | LANDLOCK_ACCESS_FS_READ_FILE;

[[noreturn]] void fail(const std::string& what) { throw std::runtime_error(what + ": " + std::strerror(errno)); }

/// Everything that this kernel's Landlock can deny.
RulesetAttributes everything(long version) {
  RulesetAttributes all;
  all.files = (1ULL << 13) - 1;
  if (version >= 2) all.files |= 1ULL << 13;
  if (version >= 3) all.files |= truncateFile;
  if (version >= 5) all.files |= deviceControl;
  if (version >= 4) all.network = tcpBindAndConnect;
  if (version >= 6) all.scoped = signalsAndAbstractSockets;
  return all;
}

std::size_t sizeKnownTo(long version) {
  if (version >= 6) return 3 * sizeof(std::uint64_t);
  return (version >= 4 ? 2 : 1) * sizeof(std::uint64_t);
}

class Ruleset {
 public:
  Ruleset() {
    const long version = syscall(SYS_landlock_create_ruleset, nullptr, 0, LANDLOCK_CREATE_RULESET_VERSION);
    if (version < 1) fail("this kernel has no Landlock");
    const RulesetAttributes all = everything(version);
    denied_ = all.files;
    ruleset_ = static_cast<int>(syscall(SYS_landlock_create_ruleset, &all, sizeKnownTo(version), 0));
    if (ruleset_ < 0) fail("Landlock makes no rules");
  }
  Ruleset(const Ruleset&) = delete;
  Ruleset& operator=(const Ruleset&) = delete;
  ~Ruleset() { close(ruleset_); }

  void allow(const std::string& path, std::uint64_t rights) {
    landlock_path_beneath_attr rule{};
    rule.parent_fd = open(path.c_str(), O_PATH | O_CLOEXEC);
    if (rule.parent_fd < 0) fail("cannot open " + path);
    struct stat info {};
    if (fstat(rule.parent_fd, &info) == 0 && !S_ISDIR(info.st_mode)) rights &= fileOnlyRights;
    rule.allowed_access = rights & denied_;
    const long result = syscall(SYS_landlock_add_rule, ruleset_, LANDLOCK_RULE_PATH_BENEATH, &rule, 0);
    close(rule.parent_fd);
    if (result != 0) fail("Landlock refuses a rule for " + path);
  }

  void enforce() const {
    if (syscall(SYS_landlock_restrict_self, ruleset_, 0) != 0) fail("Landlock cannot be enforced");
  }

 private:
  int ruleset_ = -1;
  std::uint64_t denied_ = 0;
};

/// What neither a compiler nor the worker needs: network, channels between processes, tracing, namespaces, the kernel,
/// and what Landlock does not govern: a file's mode, owner, times and attributes.
constexpr int deniedCalls[] = {
    SCMP_SYS(socket),
    SCMP_SYS(socketpair),
    SCMP_SYS(connect),
    SCMP_SYS(bind),
    SCMP_SYS(listen),
    SCMP_SYS(accept),
    SCMP_SYS(accept4),
    SCMP_SYS(sendto),
    SCMP_SYS(sendmsg),
    SCMP_SYS(shmget),
    SCMP_SYS(shmat),
    SCMP_SYS(shmctl),
    SCMP_SYS(semget),
    SCMP_SYS(msgget),
    SCMP_SYS(mq_open),
    SCMP_SYS(add_key),
    SCMP_SYS(request_key),
    SCMP_SYS(keyctl),
    SCMP_SYS(ptrace),
    SCMP_SYS(process_vm_readv),
    SCMP_SYS(process_vm_writev),
    SCMP_SYS(pidfd_open),
    SCMP_SYS(pidfd_getfd),
    SCMP_SYS(kcmp),
    SCMP_SYS(unshare),
    SCMP_SYS(setns),
    SCMP_SYS(mount),
    SCMP_SYS(umount2),
    SCMP_SYS(pivot_root),
    SCMP_SYS(chroot),
    SCMP_SYS(open_tree),
    SCMP_SYS(move_mount),
    SCMP_SYS(fsopen),
    SCMP_SYS(fsmount),
    SCMP_SYS(bpf),
    SCMP_SYS(perf_event_open),
    SCMP_SYS(userfaultfd),
    SCMP_SYS(io_uring_setup),
    SCMP_SYS(io_uring_enter),
    SCMP_SYS(io_uring_register),
    SCMP_SYS(memfd_create),
    SCMP_SYS(memfd_secret),
    SCMP_SYS(inotify_init),
    SCMP_SYS(inotify_init1),
    SCMP_SYS(fanotify_init),
    SCMP_SYS(chmod),
    SCMP_SYS(fchmod),
    SCMP_SYS(fchmodat),
    SCMP_SYS(chown),
    SCMP_SYS(fchown),
    SCMP_SYS(lchown),
    SCMP_SYS(fchownat),
    SCMP_SYS(utime),
    SCMP_SYS(utimes),
    SCMP_SYS(utimensat),
    SCMP_SYS(futimesat),
    SCMP_SYS(setxattr),
    SCMP_SYS(lsetxattr),
    SCMP_SYS(fsetxattr),
    SCMP_SYS(removexattr),
    SCMP_SYS(lremovexattr),
    SCMP_SYS(fremovexattr),
    SCMP_SYS(link),
    SCMP_SYS(linkat),
    SCMP_SYS(symlink),
    SCMP_SYS(symlinkat),
    SCMP_SYS(mknod),
    SCMP_SYS(mknodat),
    SCMP_SYS(personality),
    SCMP_SYS(name_to_handle_at),
    SCMP_SYS(open_by_handle_at),
    SCMP_SYS(init_module),
    SCMP_SYS(finit_module),
    SCMP_SYS(kexec_load),
    SCMP_SYS(syslog),
    SCMP_SYS(swapon),
    SCMP_SYS(reboot),
    SCMP_SYS(quotactl),
    SCMP_SYS(sched_setaffinity),
    SCMP_SYS(sched_setscheduler),
    SCMP_SYS(setpriority),
    SCMP_SYS(ioprio_set),
};

constexpr int chmodFrom66 = 452;      // fchmodat2, younger than this machine's header may be
constexpr int setxattrFrom613 = 463;  // setxattrat

void deny(scmp_filter_ctx filter, std::uint32_t action, int call, const std::vector<scmp_arg_cmp>& conditions = {}) {
  if (seccomp_rule_add_array(filter, action, call, static_cast<unsigned>(conditions.size()), conditions.data()) != 0) {
    throw std::runtime_error("libseccomp refused a rule");
  }
}

/// A process may start others, in its own namespaces. clone3 hides its flags from a filter: the C library falls back to
/// clone when it is told that there is none.
void denyNewNamespaces(scmp_filter_ctx filter) {
  for (const int flag :
       {CLONE_NEWNS, CLONE_NEWUTS, CLONE_NEWIPC, CLONE_NEWUSER, CLONE_NEWPID, CLONE_NEWNET, CLONE_NEWCGROUP}) {
    const auto bit = static_cast<scmp_datum_t>(flag);
    deny(filter, SCMP_ACT_ERRNO(EPERM), SCMP_SYS(clone), {{0, SCMP_CMP_MASKED_EQ, bit, bit}});
  }
  deny(filter, SCMP_ACT_ERRNO(ENOSYS), SCMP_SYS(clone3));
}

/// A rule that nobody has seen to hold is no rule.
void prove(bool readsRoot) {
  if (unshare(0) == 0) throw std::runtime_error("the filter of system calls does not hold");
  if (readsRoot) return;
  const int root = open("/", O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (root < 0) return;
  close(root);
  throw std::runtime_error("Landlock does not hold");
}

void denyCalls() {
  const scmp_filter_ctx filter = seccomp_init(SCMP_ACT_ALLOW);
  if (filter == nullptr) throw std::runtime_error("libseccomp could not start a filter");
  for (const int call : deniedCalls) deny(filter, SCMP_ACT_ERRNO(EPERM), call);
  for (const int call : {chmodFrom66, setxattrFrom613}) deny(filter, SCMP_ACT_ERRNO(ENOSYS), call);
  denyNewNamespaces(filter);
  if (seccomp_load(filter) != 0) throw std::runtime_error("the kernel refused the filter of system calls");
  seccomp_release(filter);
}

/// Reads the options, applies them, and returns the command that is left.
std::vector<char*> confine(int argc, char** argv) {
  if (prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0) fail("cannot give up privileges");
  // The group of processes is killed with its owner; this covers an owner that is killed itself.
  if (prctl(PR_SET_PDEATHSIG, SIGKILL, 0, 0, 0) != 0) fail("cannot be bound to the grader");
  umask(077);
  Ruleset rules;
  bool readsRoot = false;
  int next = 1;
  for (; next + 1 < argc && std::string(argv[next]) != "--"; next += 2) {
    const std::string option = argv[next];
    if (option != "--read" && option != "--write") throw std::runtime_error("unknown option " + option);
    if (std::string(argv[next + 1]) == "/") readsRoot = true;
    rules.allow(argv[next + 1], option == "--read" ? readRights : writeRights);
  }
  rules.enforce();
  denyCalls();
  prove(readsRoot);
  std::vector<char*> command(argv + std::min(next + 1, argc), argv + argc);
  if (command.empty())
    throw std::runtime_error("usage: muelle-confine [--read PATH]... [--write FOLDER]... -- PROGRAM ...");
  command.push_back(nullptr);
  return command;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const std::vector<char*> command = confine(argc, argv);
    execv(command.front(), command.data());
    fail(std::string("cannot run ") + command.front());
  } catch (const std::exception& error) {
    std::fprintf(stderr, "muelle-confine: %s\n", error.what());
    return 126;
  }
}
