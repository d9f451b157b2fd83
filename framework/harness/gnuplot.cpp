#include "harness/gnuplot.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>
#include <array>
#include <cerrno>
#include <cstring>
#include <stdexcept>

extern char** environ;

namespace muelle {

namespace {

/// Owns the two ends of a pipe, which no child inherits by accident.
class Pipe {
 public:
  Pipe() {
    if (::pipe(ends_.data()) != 0)
      throw std::runtime_error(fmt::format("cannot make a pipe: {}", std::strerror(errno)));
    for (const int end : ends_) ::fcntl(end, F_SETFD, FD_CLOEXEC);
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;
  ~Pipe() {
    closeEnd(0);
    closeEnd(1);
  }
  int readEnd() const { return ends_[0]; }
  int writeEnd() const { return ends_[1]; }
  void closeWriteEnd() { closeEnd(1); }

 private:
  void closeEnd(std::size_t end) {
    if (ends_[end] >= 0) ::close(ends_[end]);
    ends_[end] = -1;
  }

  std::array<int, 2> ends_{-1, -1};
};

/// What a child's descriptors and current folder become.
class SpawnActions {
 public:
  SpawnActions() { posix_spawn_file_actions_init(&actions_); }
  SpawnActions(const SpawnActions&) = delete;
  SpawnActions& operator=(const SpawnActions&) = delete;
  ~SpawnActions() { posix_spawn_file_actions_destroy(&actions_); }

  posix_spawn_file_actions_t* get() { return &actions_; }

 private:
  posix_spawn_file_actions_t actions_{};
};

/// Everything up to the end of the stream, cut at 64 KiB.
std::string drain(int descriptor) {
  constexpr std::size_t most = 64 * 1024;
  std::string text;
  std::array<char, 4096> chunk{};
  while (true) {
    const ssize_t count = ::read(descriptor, chunk.data(), chunk.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) break;
    if (text.size() < most) text.append(chunk.data(), static_cast<std::size_t>(count));
  }
  return text;
}

int waitFor(pid_t child) {
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return status;
}

/// One line out of gnuplot's several.
std::string oneLine(const std::string& text) {
  std::string line;
  for (const char c : text) {
    const bool isBlank = c == '\n' || c == '\r' || c == '\t' || c == ' ';
    if (!isBlank) line += c;
    if (isBlank && !line.empty() && line.back() != ' ') line += ' ';
  }
  return line;
}

}  // namespace

void runGnuplot(const std::filesystem::path& folder, const std::vector<std::string>& scripts) {
  std::vector<std::string> arguments = {"gnuplot", "-d"};  // -d: neither gnuplotrc nor ~/.gnuplot
  arguments.insert(arguments.end(), scripts.begin(), scripts.end());
  std::vector<char*> argv;
  for (std::string& argument : arguments) argv.push_back(argument.data());
  argv.push_back(nullptr);

  Pipe errors;
  SpawnActions actions;
  posix_spawn_file_actions_addopen(actions.get(), STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(actions.get(), STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_adddup2(actions.get(), errors.writeEnd(), STDERR_FILENO);
  posix_spawn_file_actions_addchdir_np(actions.get(), folder.c_str());
  pid_t child = -1;
  const int error = ::posix_spawnp(&child, "gnuplot", actions.get(), nullptr, argv.data(), environ);
  errors.closeWriteEnd();
  if (error != 0) {
    throw std::runtime_error(fmt::format(
        "cannot start gnuplot ({}): install it, for example with apt install gnuplot-nox", std::strerror(error)));
  }

  const std::string words = oneLine(drain(errors.readEnd()));
  const int status = waitFor(child);
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return;
  const std::string how = WIFSIGNALED(status) ? fmt::format("was ended by signal {}", WTERMSIG(status))
                                              : fmt::format("failed with status {}", WEXITSTATUS(status));
  throw std::runtime_error(fmt::format("gnuplot {}: {}", how, words.empty() ? "it said nothing" : words));
}

}  // namespace muelle
