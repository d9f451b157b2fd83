#include "harness/check/run_child.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#ifdef __linux__
#include <sys/prctl.h>
#endif

namespace muelle {

namespace {

using Clock = std::chrono::steady_clock;

constexpr int cannotStart = 127;

/// Both ends of a pipe; what is still open at the end of the scope is closed.
class Pipe {
 public:
  Pipe() {
    if (pipe2(ends_.data(), O_CLOEXEC) != 0) throw std::runtime_error(fmt::format("no pipe: {}", std::strerror(errno)));
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;
  ~Pipe() {
    closeReading();
    closeWriting();
  }
  int reading() const { return ends_[0]; }
  int writing() const { return ends_[1]; }
  void closeReading() { closeEnd(0); }
  void closeWriting() { closeEnd(1); }

 private:
  void closeEnd(std::size_t i) {
    if (ends_[i] >= 0) close(ends_[i]);
    ends_[i] = -1;
  }
  std::array<int, 2> ends_{-1, -1};
};

/// In the child between fork and exec: only calls that are safe there.
[[noreturn]] void become(const ChildRequest& request, char* const* argv, int output, int report) {
  setpgid(0, 0);
#ifdef __linux__
  // Ctrl-C ends the parent alone; the child must not go on without it.
  prctl(PR_SET_PDEATHSIG, SIGKILL);
#endif
  const rlimit noCore{0, 0};
  setrlimit(RLIMIT_CORE, &noCore);
  // An endless recursion must meet the end of the stack before the end of the memory.
  rlimit stack{};
  getrlimit(RLIMIT_STACK, &stack);
  stack.rlim_cur = std::min<rlim_t>(stack.rlim_max, 8U << 20U);
  setrlimit(RLIMIT_STACK, &stack);
  // The report first: dup2 to 1 and 2 cannot then hit it, because both pipes have descriptors from 3 on.
  const int safeOutput = fcntl(output, F_DUPFD, 10);
  const int safeReport = fcntl(report, F_DUPFD, 10);
  const int nothing = open("/dev/null", O_RDONLY);
  dup2(nothing, STDIN_FILENO);
  dup2(safeOutput, STDOUT_FILENO);
  dup2(safeOutput, STDERR_FILENO);
  dup2(safeReport, 3);
  for (const int used : {safeOutput, safeReport}) close(used);
  if (nothing > 3) close(nothing);
  if (!request.folder.empty() && chdir(request.folder.c_str()) != 0) _exit(cannotStart);
  execvp(argv[0], argv);
  _exit(cannotStart);
}

/// Reads what there is; false at the end of the stream.
bool readSome(int descriptor, std::string& text, std::size_t limit) {
  char buffer[8192];
  const ssize_t count = read(descriptor, buffer, sizeof buffer);
  if (count < 0) return errno == EINTR || errno == EAGAIN;
  if (count == 0) return false;
  if (text.size() < limit) text.append(buffer, std::min(static_cast<std::size_t>(count), limit - text.size()));
  return true;
}

/// Reads both streams until both end, or the child does, or the time is over.
void drain(pid_t child, Pipe& output, Pipe& report, const ChildRequest& request, ChildResult& result, int& status) {
  const auto deadline = Clock::now() + std::chrono::duration<double>(request.seconds);
  std::array<pollfd, 2> streams{{{output.reading(), POLLIN, 0}, {report.reading(), POLLIN, 0}}};
  bool ended = false;
  while (!ended) {
    const bool bothClosed = streams[0].fd < 0 && streams[1].fd < 0;
    // A grandchild may hold the pipes open: look after the child itself, too.
    const int ready = poll(streams.data(), streams.size(), bothClosed ? 2 : 50);
    if (ready > 0 && streams[0].revents != 0 && !readSome(streams[0].fd, result.output, request.outputLimit))
      streams[0].fd = -1;
    if (ready > 0 && streams[1].revents != 0 && !readSome(streams[1].fd, result.report, request.outputLimit))
      streams[1].fd = -1;
    if (ready == 0 || bothClosed) ended = waitpid(child, &status, WNOHANG) == child;
    if (!ended && Clock::now() > deadline) {
      result.timedOut = true;
      kill(-child, SIGKILL);
      while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
      }
      ended = true;
    }
  }
}

}  // namespace

ChildResult runChild(const ChildRequest& request) {
  Pipe output;
  Pipe report;
  std::vector<std::string> words{"env", "LC_ALL=C"};
  words.insert(words.end(), request.command.begin(), request.command.end());
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error(fmt::format("cannot start {}: {}", request.command[0], std::strerror(errno)));
  if (child == 0) become(request, argv.data(), output.writing(), report.writing());
  setpgid(child, child);
  output.closeWriting();
  report.closeWriting();
  ChildResult result;
  int status = 0;
  drain(child, output, report, request, result, status);
  kill(-child, SIGKILL);
  if (WIFEXITED(status)) result.exitCode = WEXITSTATUS(status);
  if (WIFSIGNALED(status)) result.signal = WTERMSIG(status);
  if (result.exitCode == cannotStart) {
    throw std::runtime_error(fmt::format("cannot start {}: {}", request.command[0], result.output));
  }
  return result;
}

}  // namespace muelle
