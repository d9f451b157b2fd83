#include "base/process/child.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <thread>
#ifdef __linux__
#include <sys/prctl.h>
#include <sys/syscall.h>
#endif

extern char** environ;

namespace muelle {

namespace {

using Clock = std::chrono::steady_clock;

constexpr int parking = 200;  // a child's descriptors wait from here on until the lower ones are closed
constexpr rlim_t graceSeconds = 2;

std::vector<char*> pointers(const std::vector<std::string>& texts) {
  std::vector<char*> result;
  for (const std::string& text : texts) result.push_back(const_cast<char*>(text.c_str()));
  result.push_back(nullptr);
  return result;
}

/// As a shell finds a program: in the folders of PATH, unless it has a slash.
std::string located(const std::string& program) {
  if (program.find('/') != std::string::npos) return program;
  const char* path = std::getenv("PATH");
  std::string_view folders = path != nullptr ? path : "/usr/bin:/bin";
  while (!folders.empty()) {
    const std::size_t end = std::min(folders.find(':'), folders.size());
    const std::string candidate = std::string(folders.substr(0, end)) + "/" + program;
    if (access(candidate.c_str(), X_OK) == 0) return candidate;
    folders.remove_prefix(std::min(end + 1, folders.size()));
  }
  throw std::runtime_error("cannot start " + program + ": it is not installed");
}

std::vector<std::string> environmentOf(const ChildSpec& spec) {
  std::vector<std::string> environment = spec.environment;
  if (!spec.inheritsEnvironment) return environment;
  for (char** entry = environ; *entry != nullptr; ++entry) {
    const std::string_view text = *entry;
    const std::string_view name = text.substr(0, std::min(text.find('='), text.size()));
    const bool isReplaced = std::any_of(spec.environment.begin(), spec.environment.end(), [&](const std::string& own) {
      return own.size() > name.size() && own.starts_with(name) && own[name.size()] == '=';
    });
    if (!isReplaced) environment.emplace_back(text);
  }
  return environment;
}

void closeFrom(unsigned first, unsigned last) {
  if (first > last) return;
#ifdef SYS_close_range
  syscall(SYS_close_range, first, last, 0U);
#else
  const auto open = static_cast<unsigned>(sysconf(_SC_OPEN_MAX));
  for (unsigned descriptor = first; descriptor <= std::min(last, open); ++descriptor)
    close(static_cast<int>(descriptor));
#endif
}

/// False when our own limit is lower.
template <class Resource>
bool limit(Resource resource, rlim_t value, rlim_t above = 0) {
  if (value == 0) return true;
  const rlimit both{value, value + above};
  return setrlimit(resource, &both) == 0;
}

bool applyLimits(const ResourceLimits& limits) {
#ifdef RLIMIT_NPROC
  limit(RLIMIT_NPROC, limits.processes);  // a container's own may be lower, and does as well
#endif
  const rlimit noCore{0, 0};
  setrlimit(RLIMIT_CORE, &noCore);
  return limit(RLIMIT_AS, limits.addressSpace) && limit(RLIMIT_FSIZE, limits.fileSize) &&
         limit(RLIMIT_STACK, limits.stack) && limit(RLIMIT_CPU, limits.cpuSeconds, graceSeconds);
}

/// Told by a child in place of a reason: with lower limits it would be blamed for what our own shell forbids.
constexpr int limitsOutOfReach = -1;

/// Everything that the child needs between fork and exec, made before: after fork only calls that are safe in a signal
/// handler, for other threads may hold any lock.
struct Start {
  std::string program;
  std::vector<char*> arguments;
  std::vector<char*> environment;
  std::vector<std::pair<int, int>> descriptors;
  int errorPipe;
};

void takeDescriptors(const Start& start, int& error) {
  const auto count = static_cast<int>(start.descriptors.size());
  for (int i = 0; i < count; ++i) dup2(start.descriptors[static_cast<std::size_t>(i)].second, parking + i);
  error = fcntl(start.errorPipe, F_DUPFD, parking + count);
  closeFrom(0, static_cast<unsigned>(parking) - 1);  // ours, and whatever we have inherited ourselves
  for (int i = 0; i < count; ++i) dup2(parking + i, start.descriptors[static_cast<std::size_t>(i)].first);
  closeFrom(static_cast<unsigned>(parking), static_cast<unsigned>(error) - 1);
  closeFrom(static_cast<unsigned>(error) + 1, ~0U);
  fcntl(error, F_SETFD, FD_CLOEXEC);
}

[[noreturn]] void becomeChild(const ChildSpec& spec, const Start& start) {
  int error = start.errorPipe;
  if (!spec.isForeground) {
    setsid();  // a group of its own, and no terminal
#ifdef __linux__
    prctl(PR_SET_PDEATHSIG, SIGKILL);
#endif
    takeDescriptors(start, error);
  }
  const bool isLimited = applyLimits(spec.limits);
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  // An ignored signal would stay ignored.
  for (const int ignored : {SIGPIPE, SIGXFSZ}) signal(ignored, SIG_DFL);
  if (isLimited && (spec.workingDirectory.empty() || chdir(spec.workingDirectory.c_str()) == 0)) {
    execve(start.program.c_str(), start.arguments.data(), start.environment.data());
  }
  const int reason = isLimited ? errno : limitsOutOfReach;
  [[maybe_unused]] const ssize_t told = write(error, &reason, sizeof reason);
  _exit(127);
}

void appendCut(std::string& text, const char* data, std::size_t count, std::size_t largest, bool& cut) {
  const std::size_t room = largest > text.size() ? largest - text.size() : 0;
  text.append(data, std::min(room, count));
  if (count > room) cut = true;
}

/// One output of a command: where it is read, and what is kept.
struct Stream {
  Descriptor end;
  std::string& text;
  std::size_t limit;
  bool cut = false;

  /// Reads what there is; closes the stream at its end.
  void drain() {
    std::array<char, 65536> buffer{};
    const ssize_t got = read(end.get(), buffer.data(), buffer.size());
    if (got < 0 && (errno == EINTR || errno == EAGAIN)) return;
    if (got <= 0) return end.reset();
    appendCut(text, buffer.data(), static_cast<std::size_t>(got), limit, cut);
  }
};

/// Waits for output, at most 50 ms: whoever still holds a pipe must not keep us from seeing that the child has ended.
bool drainOnce(std::vector<Stream>& streams, std::chrono::milliseconds longest) {
  std::vector<pollfd> ends;
  for (const Stream& stream : streams) ends.push_back({stream.end.get(), POLLIN, 0});
  if (poll(ends.data(), ends.size(), static_cast<int>(longest.count())) <= 0) return false;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    if (streams[i].end && ends[i].revents != 0) streams[i].drain();
  }
  return true;
}

}  // namespace

Pipe makePipe() {
  std::array<int, 2> ends{};
#ifdef __linux__
  const int result = pipe2(ends.data(), O_CLOEXEC);
#else
  const int result = pipe(ends.data());
  if (result == 0) {
    for (const int end : ends) fcntl(end, F_SETFD, FD_CLOEXEC);
  }
#endif
  if (result != 0) throw std::system_error(errno, std::generic_category(), "making a pipe");
  return {Descriptor(ends[0]), Descriptor(ends[1])};
}

Child::Child(const ChildSpec& spec) : ownsGroup_(!spec.isForeground) {
  const std::vector<std::string> environment = environmentOf(spec);
  Start start{located(spec.command.front()),
              pointers(spec.command),
              pointers(environment),
              {spec.descriptors.begin(), spec.descriptors.end()},
              -1};
  const Descriptor null(open("/dev/null", O_RDWR | O_CLOEXEC));
  for (const int standard : {0, 1, 2}) {
    if (!spec.descriptors.contains(standard)) start.descriptors.emplace_back(standard, null.get());
  }
  for (const auto& [inside, ours] : start.descriptors) {
    if (inside >= parking) throw std::runtime_error("too many descriptors for " + spec.command.front());
  }
  Pipe error = makePipe();
  start.errorPipe = error.write.get();
  pid_ = fork();
  if (pid_ < 0) throw std::system_error(errno, std::generic_category(), "starting " + spec.command.front());
  if (pid_ == 0) becomeChild(spec, start);
  error.write.reset();
  int reason = 0;
  ssize_t got = 0;
  while ((got = read(error.read.get(), &reason, sizeof reason)) < 0 && errno == EINTR) {
  }
  if (got == sizeof reason) {
    kill();
    const char* words = reason == limitsOutOfReach
                            ? "it needs more than the limits of this shell allow; raise them (ulimit -a shows them)"
                            : std::strerror(reason);
    throw std::runtime_error("cannot start " + spec.command.front() + ": " + words);
  }
}

void ignoreClosedPipes() { signal(SIGPIPE, SIG_IGN); }

Child::Child(Child&& other) noexcept
    : pid_(std::exchange(other.pid_, -1)), ownsGroup_(other.ownsGroup_), companion_(std::move(other.companion_)) {}

Child& Child::operator=(Child&& other) noexcept {
  if (this != &other) {
    kill();
    pid_ = std::exchange(other.pid_, -1);
    ownsGroup_ = other.ownsGroup_;
    companion_ = std::move(other.companion_);
  }
  return *this;
}

std::optional<ExitStatus> Child::wait(Clock::time_point deadline) {
  int status = 0;
  rusage usage{};
  auto pause = std::chrono::microseconds(100);
  for (pid_t ended = 0; (ended = wait4(pid_, &status, WNOHANG, &usage)) != pid_;) {
    if (ended < 0 && errno != EINTR) throw std::system_error(errno, std::generic_category(), "waiting for a child");
    if (Clock::now() >= deadline) return std::nullopt;
    std::this_thread::sleep_for(pause);
    pause = std::min(pause * 2, std::chrono::microseconds(5000));
  }
  if (ownsGroup_) ::kill(-pid_, SIGKILL);  // whatever it left in its group
  pid_ = -1;
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  const bool signalled = WIFSIGNALED(status);
  return ExitStatus{signalled, signalled ? WTERMSIG(status) : WEXITSTATUS(status),
                    seconds(usage.ru_utime) + seconds(usage.ru_stime)};
}

void Child::kill() {
  if (pid_ <= 0) return;
  if (ownsGroup_) ::kill(-pid_, SIGKILL);
  ::kill(pid_, SIGKILL);
  waitpid(pid_, nullptr, 0);
  pid_ = -1;
}

CommandResult runCommand(ChildSpec spec, const Capture& capture) {
  const auto deadline = Clock::now() + capture.limit;
  CommandResult result;
  Pipe out = makePipe();
  Pipe err = makePipe();
  Pipe report = makePipe();
  spec.descriptors[1] = out.write.get();
  spec.descriptors[2] = capture.together ? out.write.get() : err.write.get();
  if (capture.reportBytes > 0) spec.descriptors[3] = report.write.get();
  Child child(spec);
  for (Pipe* pipe : {&out, &err, &report}) pipe->write.reset();

  std::vector<Stream> streams;
  streams.push_back({std::move(out.read), result.out, capture.outBytes});
  streams.push_back({std::move(err.read), result.err, capture.errBytes});
  streams.push_back({std::move(report.read), result.report, capture.reportBytes});
  std::optional<ExitStatus> status;
  while (!status && Clock::now() < deadline) {
    const bool allClosed = std::none_of(streams.begin(), streams.end(), [](const Stream& s) { return bool(s.end); });
    const bool wasBusy = drainOnce(streams, std::chrono::milliseconds(allClosed ? 1 : 50));
    if (!wasBusy || allClosed) status = child.wait(Clock::now());
  }
  if (status) {
    while (drainOnce(streams, std::chrono::milliseconds(0)) &&
           std::any_of(streams.begin(), streams.end(), [](const Stream& s) { return bool(s.end); }) &&
           Clock::now() < deadline) {
    }
    result.status = *status;
  } else {
    result.timedOut = true;
    child.kill();
  }
  result.outCut = streams.front().cut;
  result.errCut = streams[1].cut;
  return result;
}

int runInForeground(const std::vector<std::string>& command) {
  std::fflush(nullptr);
  ChildSpec spec;
  spec.command = command;
  spec.inheritsEnvironment = true;
  spec.isForeground = true;
  Child child(spec);
  const ExitStatus status = *child.wait(Clock::time_point::max());
  return status.signalled ? 128 + status.code : status.code;
}

}  // namespace muelle
