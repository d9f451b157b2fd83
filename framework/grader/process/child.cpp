#include "grader/process/child.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <stdexcept>
#include <system_error>
#include <thread>

namespace muelle::grader {

namespace {

using Clock = std::chrono::steady_clock;

constexpr int parking = 200;  // a child's descriptors wait from here on until the lower ones are closed

std::vector<char*> pointers(const std::vector<std::string>& texts) {
  std::vector<char*> result;
  for (const std::string& text : texts) result.push_back(const_cast<char*>(text.c_str()));
  result.push_back(nullptr);
  return result;
}

void limit(__rlimit_resource resource, rlim_t value) {
  if (value == 0) return;
  const rlimit both{value, value};
  setrlimit(resource, &both);
}

void closeFrom(unsigned first, unsigned last) {
  if (first <= last) syscall(SYS_close_range, first, last, 0U);
}

/// After fork only calls that are safe in a signal handler: other threads may hold any lock.
[[noreturn]] void becomeChild(const ChildSpec& spec, char** arguments, char** environment,
                              const std::pair<int, int>* descriptors, std::size_t count, int errorPipe) {
  setsid();  // a group of its own, and no terminal
  for (std::size_t i = 0; i < count; ++i) dup2(descriptors[i].second, parking + static_cast<int>(i));
  const int error = fcntl(errorPipe, F_DUPFD, parking + static_cast<int>(count));
  closeFrom(0, static_cast<unsigned>(parking) - 1);  // ours, and whatever we have inherited ourselves
  for (std::size_t i = 0; i < count; ++i) dup2(parking + static_cast<int>(i), descriptors[i].first);
  closeFrom(static_cast<unsigned>(parking), static_cast<unsigned>(error) - 1);
  closeFrom(static_cast<unsigned>(error) + 1, ~0U);
  fcntl(error, F_SETFD, FD_CLOEXEC);
  limit(RLIMIT_AS, spec.limits.addressSpace);
  limit(RLIMIT_FSIZE, spec.limits.fileSize);
  limit(RLIMIT_CPU, spec.limits.cpuSeconds);
  limit(RLIMIT_NPROC, spec.limits.processes);
  const rlimit noCore{0, 0};
  setrlimit(RLIMIT_CORE, &noCore);
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  signal(SIGPIPE, SIG_DFL);  // an ignored signal would stay ignored
  if (spec.workingDirectory.empty() || chdir(spec.workingDirectory.c_str()) == 0) {
    execve(arguments[0], arguments, environment);
  }
  const int reason = errno;
  [[maybe_unused]] const ssize_t told = write(error, &reason, sizeof reason);
  _exit(127);
}

void appendCut(std::string& text, const char* data, std::size_t count, std::size_t largest, bool& cut) {
  const std::size_t room = largest > text.size() ? largest - text.size() : 0;
  text.append(data, std::min(room, count));
  if (count > room) cut = true;
}

}  // namespace

Pipe makePipe() {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) throw std::system_error(errno, std::generic_category(), "making a pipe");
  return {Descriptor(ends[0]), Descriptor(ends[1])};
}

Child::Child(const ChildSpec& spec) {
  const std::vector<char*> arguments = pointers(spec.command);
  const std::vector<char*> environment = pointers(spec.environment);
  std::vector<std::pair<int, int>> descriptors(spec.descriptors.begin(), spec.descriptors.end());
  Descriptor null(open("/dev/null", O_RDWR | O_CLOEXEC));
  for (const int standard : {0, 1, 2}) {
    if (!spec.descriptors.contains(standard)) descriptors.emplace_back(standard, null.get());
  }
  for (const auto& [inside, ours] : descriptors) {
    if (inside >= parking) throw std::runtime_error("too many descriptors for " + spec.command.front());
  }
  Pipe error = makePipe();
  pid_ = fork();
  if (pid_ < 0) throw std::system_error(errno, std::generic_category(), "starting " + spec.command.front());
  if (pid_ == 0) {
    becomeChild(spec, const_cast<char**>(arguments.data()), const_cast<char**>(environment.data()), descriptors.data(),
                descriptors.size(), error.write.get());
  }
  error.write.reset();
  int reason = 0;
  if (read(error.read.get(), &reason, sizeof reason) == sizeof reason) {
    kill();
    throw std::runtime_error("cannot start " + spec.command.front() + ": " + std::strerror(reason));
  }
}

void ignoreClosedPipes() { signal(SIGPIPE, SIG_IGN); }

Child::Child(Child&& other) noexcept : pid_(std::exchange(other.pid_, -1)), companion_(std::move(other.companion_)) {}

Child& Child::operator=(Child&& other) noexcept {
  if (this != &other) {
    kill();
    pid_ = std::exchange(other.pid_, -1);
    companion_ = std::move(other.companion_);
  }
  return *this;
}

std::optional<ExitStatus> Child::wait(Clock::time_point deadline) {
  int status = 0;
  auto pause = std::chrono::microseconds(100);
  while (waitpid(pid_, &status, WNOHANG) == 0) {
    if (Clock::now() >= deadline) return std::nullopt;
    std::this_thread::sleep_for(pause);
    pause = std::min(pause * 2, std::chrono::microseconds(5000));
  }
  ::kill(-pid_, SIGKILL);  // whatever it left in its group
  pid_ = -1;
  if (WIFSIGNALED(status)) return ExitStatus{true, WTERMSIG(status)};
  return ExitStatus{false, WEXITSTATUS(status)};
}

void Child::kill() {
  if (pid_ <= 0) return;
  ::kill(-pid_, SIGKILL);
  ::kill(pid_, SIGKILL);
  waitpid(pid_, nullptr, 0);
  pid_ = -1;
}

CommandResult runCommand(ChildSpec spec, std::chrono::milliseconds limit, std::size_t outBytes, std::size_t errBytes) {
  const auto deadline = Clock::now() + limit;
  Pipe out = makePipe();
  Pipe err = makePipe();
  spec.descriptors[1] = out.write.get();
  spec.descriptors[2] = err.write.get();
  Child child(spec);
  out.write.reset();
  err.write.reset();

  CommandResult result;
  bool errCut = false;
  std::array<pollfd, 2> ends{pollfd{out.read.get(), POLLIN, 0}, pollfd{err.read.get(), POLLIN, 0}};
  std::array<char, 65536> buffer{};
  while (ends[0].fd >= 0 || ends[1].fd >= 0) {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now()).count();
    if (left <= 0) break;
    if (poll(ends.data(), ends.size(), static_cast<int>(left)) <= 0) continue;
    for (std::size_t i = 0; i < ends.size(); ++i) {
      if (ends[i].fd < 0 || ends[i].revents == 0) continue;
      const ssize_t got = read(ends[i].fd, buffer.data(), buffer.size());
      if (got <= 0) {
        ends[i].fd = -1;
      } else if (i == 0) {
        appendCut(result.out, buffer.data(), static_cast<std::size_t>(got), outBytes, result.outCut);
      } else {
        appendCut(result.err, buffer.data(), static_cast<std::size_t>(got), errBytes, errCut);
      }
    }
  }
  if (const auto status = child.wait(deadline)) {
    result.status = *status;
  } else {
    result.timedOut = true;
    child.kill();
  }
  return result;
}

}  // namespace muelle::grader
