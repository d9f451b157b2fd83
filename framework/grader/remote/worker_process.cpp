#include "grader/remote/worker_process.h"

#include "grader/remote/fault.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <array>
#include <csignal>
#include <cstring>

namespace muelle::grader {

namespace {

constexpr std::size_t outputLimit = 64 * 1024;
constexpr auto loadingTime = std::chrono::seconds(2);
constexpr const char* loadingCode = "the code that runs when your file is loaded";
constexpr auto startingTime = std::chrono::seconds(20);  // for the sandbox itself on a busy machine

/// The libraries that the host program and a submission need: the worker sees these files and no folder.
std::vector<VisibleFile> systemLibraries() {
  std::vector<VisibleFile> files;
  files.push_back(
      {"/usr/lib64/ld-linux-x86-64.so.2", std::filesystem::canonical("/lib64/ld-linux-x86-64.so.2"), "", true});
  for (const char* name : {"libc.so.6", "libm.so.6", "libstdc++.so.6", "libgcc_s.so.1", "libseccomp.so.2"}) {
    const std::filesystem::path folder = "/usr/lib/x86_64-linux-gnu";
    files.push_back({(folder / name).string(), std::filesystem::canonical(folder / name), "", true});
  }
  return files;
}

std::string signalText(int signal) {
  switch (signal) {
    case SIGSEGV:
      return "crashed: it used memory that is not its own (segmentation fault)";
    case SIGFPE:
      return "crashed: an integer division by zero (SIGFPE)";
    case SIGABRT:
      return "called abort(): an assertion failed or memory was damaged or used up";
    case SIGSYS:
      return "was stopped: it asked the operating system for something that an exercise has no need of";
    case SIGKILL:
      return "was killed";
    case SIGXCPU:
      return "used up its processor time";
    default:
      return fmt::format("ended with signal {} ({})", signal, strsignal(signal));
  }
}

std::string textOf(const wire::Frame& frame) {
  return {reinterpret_cast<const char*>(frame.payload.data()), std::min<std::size_t>(frame.payload.size(), 2000)};
}

}  // namespace

std::string deathText(const std::string& cause) {
  if (cause == "stack overflow")
    return "ran out of stack: does it call itself without end, or hold a huge local array?";
  if (cause == "segmentation fault") return "crashed: it used memory that is not its own (segmentation fault)";
  if (cause == "bus error") return "crashed (bus error)";
  if (cause == "arithmetic exception") return "crashed: an integer division by zero (SIGFPE)";
  return fmt::format("was stopped: it asked the operating system for '{}', which no exercise needs",
                     cause.substr(0, 60));
}

WorkerProcess::WorkerProcess(const Sandbox& sandbox, const std::filesystem::path& host,
                             const std::filesystem::path& submission)
    : request_(makePipe()), reply_(makePipe()), out_(makePipe()) {
  ignoreClosedPipes();  // a submission that dies between two calls must not take the test process with it
  Confinement confinement;
  confinement.command = {"./host", "./submission.so"};
  confinement.files = systemLibraries();
  confinement.files.push_back({"/host", host, "", true});
  confinement.files.push_back({"/submission.so", submission, "", true});
  confinement.descriptors = {{1, out_.write.get()},
                             {2, out_.write.get()},
                             {wire::requestDescriptor, request_.read.get()},
                             {wire::replyDescriptor, reply_.write.get()}};
  try {
    child_ = sandbox.start(confinement);
  } catch (const std::exception& error) {
    throw GraderFault(std::string("the worker did not start: ") + error.what());
  }
  request_.read.reset();
  reply_.write.reset();
  out_.write.reset();
  for (const int end : {request_.write.get(), reply_.read.get(), out_.read.get()}) fcntl(end, F_SETFL, O_NONBLOCK);
  load();
}

void WorkerProcess::load() {
  try {
    const wire::Frame confined = receive(0, Clock::now() + startingTime, "");
    if (confined.header.kind != wire::FrameKind::Confined) throw SubmissionFault(textOf(confined));
  } catch (const SubmissionFault& error) {  // nothing of the student's has run yet
    drainOutput();
    throw GraderFault(fmt::format("the worker could not confine itself: {} {}", error.what(), output_.substr(0, 300)));
  }
  const wire::Frame frame = receive(0, Clock::now() + loadingTime, loadingCode);
  if (frame.header.kind == wire::FrameKind::Ready) return;
  if (frame.header.kind == wire::FrameKind::LoadError) {
    throw SubmissionFault("your file could not be loaded: " + textOf(frame));
  }
  if (frame.header.kind == wire::FrameKind::Died)
    throw SubmissionFault(fmt::format("{} {}", loadingCode, deathText(textOf(frame))));
  throw SubmissionFault(std::string(loadingCode) + " did not end properly: " + textOf(frame));
}

void WorkerProcess::send(wire::FrameKind kind, std::uint64_t nonce, std::uint32_t target,
                         const std::vector<std::byte>& payload, Clock::time_point deadline,
                         const std::string& function) {
  wire::FrameHeader header;
  header.kind = kind;
  header.nonce = nonce;
  header.target = target;
  header.bytes = static_cast<std::uint32_t>(payload.size());
  const auto* headerBytes = reinterpret_cast<const std::byte*>(&header);
  std::vector<std::byte> message(headerBytes, headerBytes + sizeof header);
  message.insert(message.end(), payload.begin(), payload.end());
  std::size_t sent = 0;
  while (sent < message.size()) {
    const ssize_t count = write(request_.write.get(), message.data() + sent, message.size() - sent);
    if (count > 0) {
      sent += static_cast<std::size_t>(count);
    } else if (errno == EAGAIN) {
      waitFor(request_.write.get(), POLLOUT, deadline, function);
    } else if (errno != EINTR) {
      reportEnd(function);
    }
  }
}

wire::Frame WorkerProcess::receive(std::uint64_t nonce, Clock::time_point deadline, const std::string& function) {
  wire::Frame frame;
  readFully(&frame.header, sizeof frame.header, deadline, function);
  if (frame.header.magic != wire::frameMagic) throw SubmissionFault(function + " answered with a malformed message");
  if (frame.header.bytes > wire::largestPayload) {
    throw SubmissionFault(fmt::format("{} answered with a message of {} bytes; the limit is {}", function,
                                      frame.header.bytes, wire::largestPayload));
  }
  if (frame.header.nonce != nonce) throw SubmissionFault(function + " answered a question that was not asked");
  frame.payload.resize(frame.header.bytes);
  readFully(frame.payload.data(), frame.payload.size(), deadline, function);
  return frame;
}

void WorkerProcess::readFully(void* data, std::size_t count, Clock::time_point deadline, const std::string& function) {
  auto* bytes = static_cast<char*>(data);
  while (count > 0) {
    waitFor(reply_.read.get(), POLLIN, deadline, function);
    const ssize_t got = read(reply_.read.get(), bytes, count);
    if (got == 0) reportEnd(function);
    if (got < 0) {
      if (errno == EAGAIN || errno == EINTR) continue;
      reportEnd(function);
    }
    bytes += got;
    count -= static_cast<std::size_t>(got);
  }
}

void WorkerProcess::waitFor(int descriptor, short event, Clock::time_point deadline, const std::string& function) {
  for (;;) {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now()).count();
    if (left <= 0) throw SubmissionFault(function + " did not return in time", true);
    std::array<pollfd, 2> ends{pollfd{descriptor, event, 0}, pollfd{out_.read.get(), POLLIN, 0}};
    if (poll(ends.data(), ends.size(), static_cast<int>(left)) < 0) continue;
    if (ends[1].revents != 0) drainOutput();
    if (ends[0].revents != 0) return;
  }
}

void WorkerProcess::drainOutput() {
  std::array<char, 65536> buffer{};
  for (int rounds = 0; rounds < 16; ++rounds) {  // bounded: an endless writer must not hold us here
    const ssize_t got = read(out_.read.get(), buffer.data(), buffer.size());
    if (got == 0) {
      out_.read.reset();  // poll ignores a negative descriptor
      return;
    }
    if (got < 0) return;
    const std::size_t room = outputLimit - std::min(outputLimit, output_.size());
    output_.append(buffer.data(), std::min(room, static_cast<std::size_t>(got)));
    if (static_cast<std::size_t>(got) > room && !outputCut_) {
      output_ += "\n[the rest of the output was cut]";
      outputCut_ = true;
    }
  }
}

void WorkerProcess::reportEnd(const std::string& function) {
  drainOutput();
  const auto status = child_.wait(Clock::now() + std::chrono::seconds(2));
  if (!status) throw SubmissionFault(function + " closed its connection instead of returning");
  // The sandbox passes a signal on as 128 + signal.
  if (status->signalled) throw SubmissionFault(function + " " + signalText(status->code));
  if (status->code > 128) throw SubmissionFault(function + " " + signalText(status->code - 128));
  throw SubmissionFault(fmt::format("{} ended the program with exit({}) instead of returning", function, status->code));
}

}  // namespace muelle::grader
