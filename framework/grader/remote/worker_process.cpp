#include "grader/remote/worker_process.h"

#include "course/check/fault_sentences.h"
#include "course/check/heap_damage.h"
#include "course/check/sanitizer_report.h"
#include "grader/remote/fault.h"
#include "grader/remote/finding_text.h"
#include "grader/worker/death.h"
#include "grader/worker/sanitised.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <array>
#include <csignal>

namespace muelle::grader {

namespace {

constexpr int pipeBytes = 1 << 20;  // a message in one piece, where the system grants it
constexpr std::size_t outputLimit = 64 * 1024;
constexpr auto betweenLooks = std::chrono::milliseconds(25);
constexpr std::chrono::nanoseconds endless = std::chrono::nanoseconds::max();

/// The libraries that the host program and a submission need: the worker sees these files and no folder.
std::vector<VisibleFile> systemLibraries(bool sanitised) {
  std::vector<VisibleFile> files;
  files.push_back(
      {"/usr/lib64/ld-linux-x86-64.so.2", std::filesystem::canonical("/lib64/ld-linux-x86-64.so.2"), "", true});
  std::vector<std::string> names = {"libc.so.6", "libm.so.6", "libstdc++.so.6", "libgcc_s.so.1", "libseccomp.so.2"};
  if (sanitised) names.insert(names.end(), {"libasan.so.8", "libubsan.so.1"});
  for (const std::string& name : names) {
    const std::filesystem::path folder = "/usr/lib/x86_64-linux-gnu";
    files.push_back({(folder / name).string(), std::filesystem::canonical(folder / name), "", true});
  }
  return files;
}

SubmissionFault killedFromOutside(const std::string& function, int signal) {
  return SubmissionFault(fmt::format("{} was killed from outside (signal {})", function, signal), Outcome::Killed);
}

/// A signal that only the code itself can have caused, or that comes from outside. \param output of the process
SubmissionFault signalFault(const std::string& function, int signal, const std::string& output) {
  const auto fault = [&function](const std::string& what, Outcome outcome) {
    return SubmissionFault(function + " " + what, outcome);
  };
  if (signal == SIGABRT) {
    if (const std::string damage = heapDamage(output); !damage.empty()) return fault(damage, Outcome::Crash);
  }
  if (const char* sentence = signalSentence(signal)) return fault(sentence, Outcome::Crash);
  switch (signal) {
    case SIGSYS:
      return fault("was stopped: it asked the operating system for something that an exercise has no need of",
                   Outcome::Forbidden);
    case SIGXCPU:
      return fault("used up its processor time", Outcome::Cpu);
    default:  // the worker's filter lets it send itself none of these
      return killedFromOutside(function, signal);
  }
}

std::string memoryText(std::size_t bytes) {
  return bytes >= 1UL << 30 ? fmt::format("{} GiB", bytes >> 30) : fmt::format("{} MiB", bytes >> 20);
}

std::string seconds(std::chrono::milliseconds time) {
  return fmt::format("{} s", static_cast<double>(time.count()) / 1000.0);
}

}  // namespace

SubmissionFault deathFault(const std::string& who, const std::string& cause) {
  const auto fault = [&who](const std::string& what, Outcome outcome, bool isConfirmed = false) {
    return SubmissionFault(who + " " + what, outcome, isConfirmed);
  };
  if (cause == "stack overflow") return fault(stackOverflowSentence, Outcome::Crash);
  if (cause == "illegal instruction" || cause == worker::traceTrap) return fault(nowhereSentence, Outcome::Crash);
  if (cause == "floating-point trap") return fault(trapSentence, Outcome::Crash);
  if (cause == worker::vainWrite) return fault("wrote where nothing can be written", Outcome::Crash);
  // By its own word: a submission may say so, too. Whoever judges tries once more.
  if (cause == worker::signalFromOutside) return fault(struckSentence, Outcome::Struck);
  if (cause == "segmentation fault" || cause == "bus error") return fault(badMemorySentence, Outcome::Crash);
  if (cause == "arithmetic exception") return fault(divisionSentence, Outcome::Crash);
  if (cause.starts_with(worker::uncaughtException)) {
    return fault(uncaughtSentence(cause.substr(worker::uncaughtException.size())), Outcome::Crash);
  }
  if (cause.starts_with(worker::sanitiserFinding)) {
    const std::string finding = cause.substr(std::string_view(worker::sanitiserFinding).size());
    const Outcome confirmed = confirmedOutcome(finding);
    const bool isConfirmed = confirmed != Outcome::Passed;
    return fault(findingText(finding), isConfirmed ? confirmed : Outcome::Crash, isConfirmed);
  }
  return fault(
      fmt::format("was stopped: it asked the operating system for '{}', which no exercise needs", cause.substr(0, 60)),
      Outcome::Forbidden);
}

WorkerProcess::WorkerProcess(const Sandbox& sandbox, const WorkerHost& host, const std::filesystem::path& submission,
                             const SessionLimits& limits)
    : request_(makePipe()),
      reply_(makePipe()),
      out_(makePipe()),
      largestMemory_(host.sanitised ? limits.sanitisedMemory : 0),
      hasProcessBetween_(sandbox.choice() == SandboxChoice::Bubblewrap) {
  for (const int end : {request_.write.get(), reply_.write.get()}) fcntl(end, F_SETPIPE_SZ, pipeBytes);
  ignoreClosedPipes();  // a submission that dies between two calls must not take the test process with it
  constexpr auto slack = std::chrono::seconds(3);  // our own watch comes first
  const auto cpuSeconds = std::chrono::ceil<std::chrono::seconds>(limits.load + limits.criterion + slack);
  Confinement confinement;
  confinement.command = {"./host", "./submission.so", std::to_string(cpuSeconds.count())};
  if (host.refilled) confinement.command.emplace_back(worker::refilledFlag);
  confinement.files = systemLibraries(host.sanitised);
  confinement.files.push_back({"/host", host.program, "", true});
  confinement.files.push_back({"/submission.so", submission, "", true});
  confinement.environment = {"GLIBC_TUNABLES=glibc.malloc.tcache_count=0"};  // or freed memory comes back unfilled
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
  load(limits);
}

/// A frame from before the first instruction of the student's.
void WorkerProcess::expectConfined(const Patience& patience) {
  try {
    const wire::Frame frame = receive(0, patience, "the worker");
    if (frame.header.kind == wire::FrameKind::Confined) return;
    if (frame.header.kind == wire::FrameKind::LoadError) {
      throw SubmissionFault("your file could not be loaded: " + wire::shortTextOf(frame), Outcome::Crash);
    }
    throw GraderFault("the worker could not confine itself: " + wire::shortTextOf(frame));
  } catch (const SubmissionFault& error) {
    drainOutput();
    if (error.outcome() == Outcome::Killed || error.outcome() == Outcome::Wall) throw;
    if (std::string_view(error.what()).starts_with("your file")) throw;
    throw GraderFault(fmt::format("the worker could not confine itself: {} {}", error.what(), output_.substr(0, 300)));
  }
}

/// What comes when the code has run that runs at the load.
wire::Frame WorkerProcess::loaded(std::chrono::milliseconds limit, const Patience& patience) {
  try {
    return receive(0, patience, loadingCode);
  } catch (const SubmissionFault& error) {
    if (error.outcome() != Outcome::Cpu) throw;
    throw SubmissionFault(fmt::format("{} {}", loadingCode, limitSentence(limit)), Outcome::Cpu);
  }
}

void WorkerProcess::load(const SessionLimits& limits) {
  expectConfined({endless, Clock::now() + limits.startWall, limits.startWall});
  watch_ = ProcessWatch(child_.pid());
  drainOutput();
  output_.clear();  // words of the sanitizer about its surroundings: nothing of the student's has run yet
  const Patience loading = patience(limits.load, limits.loadWall);
  expectConfined(loading);
  const wire::Frame frame = loaded(limits.load, loading);
  if (frame.header.kind == wire::FrameKind::Ready) return;
  if (frame.header.kind == wire::FrameKind::LoadError) {
    throw SubmissionFault("your file could not be loaded: " + wire::shortTextOf(frame), Outcome::Crash);
  }
  if (frame.header.kind == wire::FrameKind::Died) throw deathFault(loadingCode, wire::shortTextOf(frame));
  throw SubmissionFault(std::string(loadingCode) + " did not end properly: " + wire::shortTextOf(frame),
                        Outcome::Crash);
}

Patience WorkerProcess::patience(std::chrono::nanoseconds cpu, std::chrono::milliseconds wall) const {
  return {watch_.cpu() + cpu, Clock::now() + wall, wall};
}

void WorkerProcess::end() {
  drainOutput();
  child_.kill();
}

void WorkerProcess::send(wire::FrameKind kind, std::uint64_t nonce, std::uint32_t target,
                         const std::vector<std::byte>& payload, const Patience& patience, const std::string& function) {
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
      waitFor(request_.write.get(), POLLOUT, patience, function);
    } else if (errno != EINTR) {
      throwLastWords(function);
      reportEnd(function);
    }
  }
}

wire::Frame WorkerProcess::receive(std::uint64_t nonce, const Patience& patience, const std::string& function) {
  wire::Frame frame;
  readFully(&frame.header, sizeof frame.header, patience, function);
  if (frame.header.magic != wire::frameMagic) throw SubmissionFault(function + " answered with a malformed message");
  if (frame.header.bytes > wire::largestPayload) {
    throw SubmissionFault(fmt::format("{} answered with a message of {} bytes; the limit is {}", function,
                                      frame.header.bytes, wire::largestPayload));
  }
  // One may die between two questions: that earns nothing.
  const bool isAsked = frame.header.nonce == nonce || frame.header.kind == wire::FrameKind::Died;
  if (!isAsked) throw SubmissionFault(function + " answered a question that was not asked");
  frame.payload.resize(frame.header.bytes);
  readFully(frame.payload.data(), frame.payload.size(), patience, function);
  return frame;
}

void WorkerProcess::readFully(void* data, std::size_t count, const Patience& patience, const std::string& function) {
  auto* bytes = static_cast<char*>(data);
  while (count > 0) {
    waitFor(reply_.read.get(), POLLIN, patience, function);
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

void WorkerProcess::waitFor(int descriptor, short event, const Patience& patience, const std::string& function) {
  for (;;) {
    const Clock::time_point now = Clock::now();
    if (now - lastLook_ >= betweenLooks) {
      lastLook_ = now;
      look(patience, function);
    }
    std::array<pollfd, 2> ends{pollfd{descriptor, event, 0}, pollfd{out_.read.get(), POLLIN, 0}};
    if (poll(ends.data(), ends.size(), static_cast<int>(betweenLooks.count())) < 0) continue;
    if (ends[1].revents != 0) drainOutput();
    if (ends[0].revents != 0) return;
  }
}

void WorkerProcess::look(const Patience& patience, const std::string& function) {
  if (watch_.cpu() > patience.cpu) throw SubmissionFault(function + " used up its processor time", Outcome::Cpu);
  if (largestMemory_ > 0 && watch_.residentBytes() > largestMemory_) {
    throw SubmissionFault(fmt::format("{} used more than {} of memory", function, memoryText(largestMemory_)),
                          Outcome::Crash);
  }
  watch_.observe();
  constexpr auto longestSleep = std::chrono::milliseconds(5000);
  if (watch_.sleptFor(std::min(longestSleep, patience.wallSpan / 2))) {
    throw SubmissionFault(fmt::format("{} {}", function, waitsSentence), Outcome::Crash);
  }
  if (Clock::now() < patience.wall) return;
  throw SubmissionFault(fmt::format("{} did not return within {} on the clock", function, seconds(patience.wallSpan)),
                        Outcome::Wall);
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

void WorkerProcess::throwLastWords(const std::string& function) {
  constexpr std::uint32_t longest = 2000;
  wire::Frame frame;
  if (read(reply_.read.get(), &frame.header, sizeof frame.header) != sizeof frame.header) return;
  if (frame.header.kind != wire::FrameKind::Died || frame.header.bytes > longest) return;
  frame.payload.resize(frame.header.bytes);
  if (read(reply_.read.get(), frame.payload.data(), frame.payload.size()) != static_cast<ssize_t>(frame.header.bytes))
    return;
  throw deathFault(function, wire::shortTextOf(frame));
}

void WorkerProcess::reportEnd(const std::string& function) {
  drainOutput();
  const auto status = child_.wait(Clock::now() + std::chrono::seconds(2));
  if (!status) throw SubmissionFault(function + " closed its connection instead of returning", Outcome::Crash);
  // The sandbox passes a signal on as 128 + signal; the worker's filter lets no code choose such a status. No code of a
  // student's runs in the sandbox's own process: what ends that is from outside.
  if (status->signalled && hasProcessBetween_) throw killedFromOutside(function, status->code);
  if (status->signalled) throw signalFault(function, status->code, output_);
  constexpr int everyBit = 255;  // exit(-1)
  if (status->code > 128 && status->code != everyBit) throw signalFault(function, status->code - 128, output_);
  throw SubmissionFault(fmt::format("{} {}", function, exitSentence(status->code)), Outcome::Crash);
}

}  // namespace muelle::grader
