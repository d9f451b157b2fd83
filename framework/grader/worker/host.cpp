/// \file
/// The worker: a trusted program that is already confined when it starts, installs its filter, and only then loads the
/// shared object with the student's code. It reads calls from one pipe and writes results to another.
///
/// Whatever happens in this process after the load is the student's word; the test process believes none of it.

#include "base/process/signal_origin.h"
#include "grader/wire/frame.h"
#include "grader/worker/death.h"
#include "grader/worker/filter.h"
#include "grader/worker/filter_at_load.h"
#include "grader/worker/glue.h"
#include "grader/worker/limits.h"
#include "grader/worker/sanitised.h"

#include <dlfcn.h>
#include <limits.h>
#include <malloc.h>
#include <sys/prctl.h>
#include <unistd.h>
#include <array>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <filesystem>
#include <stdexcept>
#include <string>

namespace {

using namespace muelle::grader;

constexpr std::size_t longestText = 1000;  // of an exception's, as far as it is told
constexpr int failure = 3;                 // exit status: the host's own trouble, told apart from the student's

void writeAll(const void* data, std::size_t count) {
  const auto* bytes = static_cast<const char*>(data);
  while (count > 0) {
    const ssize_t written = write(wire::replyDescriptor, bytes, count);
    if (written <= 0) _exit(failure);
    bytes += written;
    count -= static_cast<std::size_t>(written);
  }
}

void readAll(void* data, std::size_t count) {
  auto* bytes = static_cast<char*>(data);
  while (count > 0) {
    const ssize_t got = read(wire::requestDescriptor, bytes, count);
    if (got <= 0) _exit(0);  // the test process has closed the pipe: it is done
    bytes += got;
    count -= static_cast<std::size_t>(got);
  }
}

void send(wire::FrameKind kind, std::uint64_t nonce, std::uint32_t target, const void* data, std::size_t count) {
  wire::FrameHeader header;
  header.kind = kind;
  header.nonce = nonce;
  header.target = target;
  header.bytes = static_cast<std::uint32_t>(count);
  if (sizeof header + count > PIPE_BUF) {
    writeAll(&header, sizeof header);
    writeAll(data, count);
    return;
  }
  // In one piece: a signal that strikes between two writes would put its last words into the middle of an answer.
  std::array<std::byte, PIPE_BUF> frame;  // NOLINT(cppcoreguidelines-pro-type-member-init): written before it is read
  std::memcpy(frame.data(), &header, sizeof header);
  if (count > 0) std::memcpy(frame.data() + sizeof header, data, count);
  writeAll(frame.data(), sizeof header + count);
}

void sendText(wire::FrameKind kind, std::uint64_t nonce, const std::string& text) {
  send(kind, nonce, 0, text.data(), text.size());
}

wire::Frame receive() {
  wire::Frame frame;
  readAll(&frame.header, sizeof frame.header);
  frame.payload.resize(frame.header.bytes);
  if (frame.header.bytes > 0) readAll(frame.payload.data(), frame.payload.size());
  return frame;
}

std::string textOf(const wire::Frame& frame) {
  return {reinterpret_cast<const char*>(frame.payload.data()), frame.payload.size()};
}

std::uint64_t currentNonce = 0;  // for the signal handlers

class Port : public worker::HostPort {
 public:
  std::vector<std::byte> callback(std::uint32_t id, const std::vector<std::byte>& arguments) override {
    send(wire::FrameKind::Callback, currentNonce, id, arguments.data(), arguments.size());
    wire::Frame answer = receive();
    if (answer.header.kind == wire::FrameKind::AnswerThrew) throw std::runtime_error(textOf(answer));
    return std::move(answer.payload);
  }

  [[noreturn]] void refuse(const std::string& condition, const std::string& function, bool indexKnown,
                           long index) override {
    const std::string known = indexKnown ? std::to_string(index) : "";
    sendText(wire::FrameKind::Refused, currentNonce, condition + '\n' + function + '\n' + known);
    _exit(0);
  }
};

[[noreturn]] void die(const char* cause) {
  std::size_t length = 0;
  while (cause[length] != '\0') ++length;
  send(wire::FrameKind::Died, currentNonce, 0, cause, length);
  _exit(failure);
}

/// A fault near the stack pointer is a stack that has outgrown its limit.
void onFault(int signal, siginfo_t* info, void* context) {
  if (muelle::wasSentByAnother(*info)) die(worker::signalFromOutside.data());
  const auto* machine = static_cast<const ucontext_t*>(context);
  const auto address = reinterpret_cast<std::uintptr_t>(info->si_addr);
  const auto stackPointer = static_cast<std::uintptr_t>(machine->uc_mcontext.gregs[REG_RSP]);
  constexpr std::uintptr_t near = 64UL * 1024;
  const bool overflow = address + near > stackPointer && address < stackPointer + near;
  if (signal == SIGSYS) {
    die(worker::systemCallName(info->si_syscall));
  }
  if (signal == SIGSEGV && overflow) die("stack overflow");
  if (signal == SIGFPE && info->si_code != FPE_INTDIV) die("floating-point trap");
  die(signal == SIGSEGV ? "segmentation fault" : signal == SIGBUS ? "bus error" : "arithmetic exception");
}

/// abort(), an instruction that there is not, and what ends a process that writes where nobody reads or nothing fits.
/// It does not return: the filter allows no way back from a handler.
void onEnd(int signal, siginfo_t* info, void*) {
  if (muelle::wasSentByAnother(*info)) die(worker::signalFromOutside.data());
  if (signal == SIGILL) die("illegal instruction");
  if (signal == SIGTRAP) die(worker::traceTrap.data());
  if (signal == SIGPIPE || signal == SIGXFSZ) die(worker::vainWrite.data());
  raise(signal);  // the handler is gone: the process ends as abort() would have ended it
}

/// As out of a noexcept function. Whatever goes wrong on the way calls it again.
void onTerminate() {
  static bool isSecond = false;
  const std::exception_ptr exception = std::current_exception();
  if (isSecond || !exception) std::abort();
  isSecond = true;
  std::string cause(worker::uncaughtException);
  try {
    std::rethrow_exception(exception);
  } catch (const std::exception& error) {
    if (const char* text = error.what(); text != nullptr) cause.append(text, strnlen(text, longestText));
  } catch (...) {
  }
  die(cause.c_str());
}

void installHandlers() {
  constexpr std::size_t bytes = 64UL * 1024;
  static char stack[bytes];
  stack_t alternative{};
  alternative.ss_sp = stack;
  alternative.ss_size = bytes;
  sigaltstack(&alternative, nullptr);
  struct sigaction action {};
  action.sa_sigaction = onFault;
  action.sa_flags = static_cast<int>(SA_SIGINFO | SA_ONSTACK | SA_RESETHAND);
  for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGSYS}) sigaction(signal, &action, nullptr);
  action.sa_sigaction = onEnd;
  action.sa_flags |= static_cast<int>(SA_NODEFER);
  for (const int signal : {SIGABRT, SIGILL, SIGTRAP, SIGPIPE, SIGXFSZ}) sigaction(signal, &action, nullptr);
  std::set_terminate(onTerminate);
}

/// The loader has mapped the submission; nothing of it has run.
void switchFilters() {
  try {
    worker::installRunningFilter();
    send(wire::FrameKind::Confined, 0, 0, nullptr, 0);
  } catch (const std::exception& error) {
    sendText(wire::FrameKind::HostError, 0, error.what());
    _exit(failure);
  }
}

/// Memory from new and malloc holds the same senseless bytes at every run, so that reading what was never written gives
/// no right answer by chance. AddressSanitizer has an allocator of its own.
void fillFreshMemory(bool withZeros) {
  if (!worker::isSanitised) mallopt(M_PERTURB, withZeros ? 0xff : 0x01);  // fresh memory gets the complement
}

void serveForEver(worker::ServeFunction serve) {
  Port port;
  for (;;) {
    const wire::Frame request = receive();
    currentNonce = request.header.nonce;
    std::vector<std::byte> result;
    std::string text;
    switch (serve(request.header.target, request.payload, result, text, port)) {
      case worker::Served::Returned:
        send(wire::FrameKind::Result, currentNonce, request.header.target, result.data(), result.size());
        break;
      case worker::Served::Threw:
        sendText(wire::FrameKind::Thrown, currentNonce, text.substr(0, longestText));
        break;
      case worker::Served::Unknown:
        sendText(wire::FrameKind::LoadError, currentNonce, "the submission does not serve this function");
        break;
    }
  }
}

}  // namespace

void muelle::grader::worker::dieSaying(const char* cause) { die(cause); }

int main(int argc, char** argv) {
  const bool isRefilled = argc == 4 && std::string_view(argv[3]) == worker::refilledFlag;
  if (argc != 3 && !isRefilled) return failure;
  std::string file;  // absolute: the loader would ask for the working folder, which the filter forbids
  try {
    file = std::filesystem::absolute(argv[1]).string();
    worker::systemCallName(0);  // builds the table while allocating is still safe
    prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
    prctl(PR_SET_DUMPABLE, 0, 0, 0, 0);
    worker::applyLimits(static_cast<unsigned>(std::strtoul(argv[2], nullptr, 10)));
    installHandlers();
    worker::callWhenMapped(switchFilters);
    fillFreshMemory(isRefilled);
    worker::installLoadingFilter();
  } catch (const std::exception& error) {
    sendText(wire::FrameKind::HostError, 0, error.what());
    return failure;
  }
  send(wire::FrameKind::Confined, 0, 0, nullptr, 0);
  void* submission = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (submission == nullptr) {
    sendText(wire::FrameKind::LoadError, 0, dlerror());
    return 0;
  }
  if (!worker::mappedActionCalled()) {
    sendText(wire::FrameKind::HostError, 0, "the second filter of system calls was not installed");
    return failure;
  }
  const auto serve = reinterpret_cast<worker::ServeFunction>(dlsym(submission, worker::serveSymbol));
  if (serve == nullptr) {
    sendText(wire::FrameKind::LoadError, 0, "the submission has no entry point");
    return 0;
  }
  send(wire::FrameKind::Ready, 0, 0, nullptr, 0);
  serveForEver(serve);
}
