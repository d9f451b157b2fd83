#pragma once
#include "grader/wire/bytes.h"

#include <algorithm>
#include <string>
#include <vector>

namespace muelle::grader::wire {

/// What a frame says.
enum class FrameKind : std::uint32_t {
  Ready = 1,       ///< worker: the submission is loaded
  LoadError = 2,   ///< worker: it could not be loaded; payload: text
  Call = 3,        ///< test: call function `target`; payload: arguments
  Result = 4,      ///< worker: what the function returned, then its out-parameters
  Callback = 5,    ///< worker: call the test's function `target`; payload: arguments
  Answer = 6,      ///< test: what that function returned
  Thrown = 7,      ///< worker: the function threw; payload: text
  Refused = 8,     ///< worker: an assertion of Eigen refused an operation; payload: condition, function, index by lines
  Died = 9,        ///< worker: a signal ended it; payload: "stack overflow", or the forbidden system call's name
  HostError = 10,  ///< worker: the host could not confine itself; the grader's fault
  Confined = 11,   ///< worker: a filter stands; after the second, whatever comes may be the student's word
  AnswerThrew = 12,  ///< test: in place of an Answer, the function threw, which goes on in the worker; payload: text
};

/// Precedes every message. The nonce is fresh and random for each call; every frame of that call repeats it.
struct FrameHeader {
  std::uint32_t magic = 0x4d75656c;  // "Muel"
  FrameKind kind = FrameKind::Ready;
  std::uint64_t nonce = 0;
  std::uint32_t target = 0;
  std::uint32_t bytes = 0;
};
static_assert(sizeof(FrameHeader) == 24);

inline constexpr std::uint32_t frameMagic = FrameHeader{}.magic;
inline constexpr std::uint32_t largestPayload = 16 * 1024 * 1024;  ///< [bytes] refused beyond, before allocation
inline constexpr int requestDescriptor = 3;                        ///< where the worker reads calls
inline constexpr int replyDescriptor = 4;                          ///< where it writes answers

/// A whole message.
struct Frame {
  FrameHeader header;
  std::vector<std::byte> payload;
};

/// The text that a frame holds, at most 2000 bytes of it: a submission decides how long it is.
inline std::string shortTextOf(const Frame& frame) {
  return {reinterpret_cast<const char*>(frame.payload.data()), std::min<std::size_t>(frame.payload.size(), 2000)};
}

}  // namespace muelle::grader::wire
