#include "course/check/sanitizer_report.h"

#include "course/check/fault_sentences.h"
#include "course/check/second_look.h"
#include "course/check/source_tokens.h"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <charconv>

namespace muelle {

namespace {

struct FindingKind {
  std::string_view word;  ///< AddressSanitizer's
  std::string_view sentence;
  Outcome outcome = Outcome::Crash;
};

constexpr const char* beyondMemory = "reads or writes beyond the end of a std::vector or of memory from new";
constexpr const char* beyondLocal = "reads or writes beyond the end of a local array or variable";
constexpr const char* unwritten =
    "reads a bool or an enum to which nothing was written: give every variable a value before it is read";
constexpr const char* tooMuch = "asks for more memory than there is";

/// The first word that is found counts: a longer one stands before its end.
constexpr auto kinds = std::to_array<FindingKind>({
    {"stack-use-after-scope", "uses a temporary or local variable that is gone"},
    {"stack-use-after-return", "uses a local variable of a function that has returned"},
    {"heap-use-after-free",
     "uses memory that was given back: a reference or iterator into a std::vector that has grown, or a value that is "
     "gone"},
    {"double-free", "gives memory back twice"},
    {"attempting free on address", "gives back memory that new has not given"},
    {"bad-free", "gives back memory that new has not given"},
    {"stack-buffer-overflow", beyondLocal},
    {"stack-buffer-underflow", "reads or writes before the beginning of a local array or variable"},
    {"heap-buffer-overflow", beyondMemory},
    {"container-overflow", beyondMemory},
    {"global-buffer-overflow", "reads or writes beyond the end of a global array or constant"},
    {"stack-overflow", stackOverflowSentence, Outcome::Passed},
    {"requested allocation size", tooMuch, Outcome::Passed},
    {"allocation-size-too-big", tooMuch, Outcome::Passed},
    {"calloc-overflow", tooMuch, Outcome::Passed},
    {"out of memory", tooMuch, Outcome::Passed},
    {"out-of-memory", tooMuch, Outcome::Passed},
    {"reached the end of a value-returning function", "ends without returning a value"},
    {"is not a valid value for type", unwritten, Outcome::NeverWritten},
    {"invalid-value", unwritten, Outcome::NeverWritten},
    {"missing-return", "ends without returning a value"},
});

/// What a finding is; without words and of no outcome when it is none of these.
FindingKind kindOf(std::string_view finding) {
  const auto kind =
      std::ranges::find_if(kinds, [&](const FindingKind& k) { return finding.find(k.word) != std::string_view::npos; });
  return kind == kinds.end() ? FindingKind{"", "", Outcome::Passed} : *kind;
}

/// A line of a student's file.
struct Place {
  const StudentFile* file = nullptr;
  int line = 0;

  std::string text() const { return file == nullptr ? "" : fmt::format("{}:{}", file->name, line); }
};

/// Where the text first mentions a line of a student's file; no file when it does not.
Place placeIn(std::string_view text, const std::vector<StudentFile>& files) {
  std::size_t first = std::string_view::npos;
  Place place;
  for (const StudentFile& file : files) {
    const std::string key = file.name + ":";
    for (std::size_t at = text.find(key); at != std::string_view::npos && at < first; at = text.find(key, at + 1)) {
      int line = 0;
      const std::string_view rest = text.substr(at + key.size());
      const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), line);
      const bool isWhole = at == 0 || text[at - 1] == '/' || text[at - 1] == ' ' || text[at - 1] == '\n';
      if (error != std::errc() || !isWhole) continue;
      first = at;
      place = {&file, line};
    }
  }
  return place;
}

/// The usual cause, where it may be the one.
std::string_view aboutAuto(const FindingKind& kind, const Place& place) {
  const bool isOfScope = kind.word == "stack-use-after-scope" && place.file != nullptr;
  if (!isOfScope || !isInFunctionOfLine(place.file->text, place.line, "auto")) return "";
  return " ('auto' keeps no Eigen expression's values: write Vec3 or VecX)";
}

/// The file that may have given its lines another file's name, by #line; "" when none may.
std::string renamed(const std::vector<StudentFile>& files) {
  const auto file = std::ranges::find_if(files, [](const StudentFile& f) { return mayHideWarnings(f.text); });
  return file == files.end() ? "" : file->name;
}

}  // namespace

std::string_view sanitizerSentence(std::string_view finding) { return kindOf(finding).sentence; }

Outcome confirmedOutcome(std::string_view finding) { return kindOf(finding).outcome; }

SanitizerFinding explainSanitizers(std::string_view output, const std::vector<StudentFile>& files) {
  const std::size_t start = std::min(output.find("ERROR: AddressSanitizer: "), output.find(": runtime error: "));
  if (start == std::string_view::npos) return {};
  // UndefinedBehaviorSanitizer puts the place in front of its words.
  const std::size_t line = start == 0 ? 0 : output.rfind('\n', start) + 1;
  const std::string_view report = output.substr(line);
  const std::string_view headline = output.substr(line, output.find('\n', start) - line);
  const FindingKind kind = kindOf(headline);
  if (kind.outcome == Outcome::Passed) return {};
  const Place place = placeIn(report, files);
  const std::string where = place.file == nullptr ? renamed(files) : place.text();
  if (where.empty()) return {};
  return {fmt::format("{} {}{}", where, kind.sentence, aboutAuto(kind, place)), kind.outcome};
}

}  // namespace muelle
