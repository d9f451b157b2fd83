/// \file
/// Asks the kernel for what the list of system calls used with Landlock must refuse, and prints "NAME refused", or
/// "NAME done" for what it was given. Argument: a folder in which it may write.

#include <fcntl.h>
#include <linux/io_uring.h>
#include <sched.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>
#include <utime.h>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <string>
#include <utility>

namespace {

void say(const char* name, long result) {
  const bool isRefused = result < 0 && (errno == EPERM || errno == ENOSYS);
  std::printf("%s %s\n", name, isRefused ? "refused" : result < 0 ? "failed" : "done");
  std::fflush(stdout);  // or a child would print it again
}

void askForModes(const char* path, int file) {
  say("chmod", syscall(SYS_chmod, path, 0755));
  say("fchmod", fchmod(file, 0755));
  say("fchmodat", fchmodat(AT_FDCWD, path, 0755, 0));
  say("fchmodat2", syscall(452, AT_FDCWD, path, 0755, 0));
  say("chown", chown(path, getuid(), getgid()));
}

void askForTimes(const char* path, int file) {
  say("utime", utime(path, nullptr));
  say("utimes", utimes(path, nullptr));
  say("futimens", futimens(file, nullptr));
  say("utimensat", utimensat(AT_FDCWD, path, nullptr, 0));
}

/// A child in new namespaces ends at once.
void askForNamespaces() {
  for (const auto& [name, flag] : {std::pair{"unshare_user", CLONE_NEWUSER}, std::pair{"unshare_mounts", CLONE_NEWNS}})
    say(name, unshare(flag));
  const long child = syscall(SYS_clone, CLONE_NEWUSER | SIGCHLD, nullptr, nullptr, nullptr, 0);
  if (child == 0) _exit(0);
  say("clone_user", child);
  if (child > 0) waitpid(static_cast<pid_t>(child), nullptr, 0);
  alignas(8) unsigned long arguments[11] = {CLONE_NEWUSER, 0, 0, 0, SIGCHLD};
  const long other = syscall(SYS_clone3, arguments, sizeof arguments);
  if (other == 0) _exit(0);
  say("clone3_user", other);
  if (other > 0) waitpid(static_cast<pid_t>(other), nullptr, 0);
}

void askForMemoryAndRings() {
  io_uring_params parameters{};
  say("io_uring_setup", syscall(SYS_io_uring_setup, 2, &parameters));
  say("memfd_create", syscall(SYS_memfd_create, "file", 0));
  say("memfd_secret", syscall(SYS_memfd_secret, 0));
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  const std::string path = std::string(argv[1]) + "/file";
  const int file = open(path.c_str(), O_CREAT | O_RDWR, 0600);
  if (file < 0) return 3;
  askForModes(path.c_str(), file);
  askForTimes(path.c_str(), file);
  askForNamespaces();
  askForMemoryAndRings();
  std::puts("end");
}
