#pragma once
#include <cstddef>
#include <string>

namespace muelle {

/// A larger source file [bytes] is refused unread.
inline constexpr std::size_t largestSource = 256UL * 1024;

/// A source as the compiler gets it.
struct SourceText {
  std::string text;
  std::string note;     ///< what was done: "converted from UTF-16"; "" when nothing that one must know
  std::string refusal;  ///< completes "spring_1d.cpp ...": "is no text: ..."; "" when it is text
};

/// Makes text of a file's bytes: UTF-16 with its byte order mark becomes UTF-8, a UTF-8 mark goes, line ends that are
/// carriage returns alone become line feeds (a compiler would see one line). Everything else stays byte by byte,
/// Latin-1 too: the compiler decides. A file that holds a NUL is no text.
SourceText readSource(std::string bytes);

}  // namespace muelle
