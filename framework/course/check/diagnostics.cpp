#include "course/check/diagnostics.h"

#include "base/text/count.h"
#include "base/text/printable.h"
#include "base/text/words.h"
#include "course/check/explanations.h"
#include "course/check/odd_characters.h"
#include "course/check/plain_types.h"
#include "course/check/source_tokens.h"

#include <fmt/format.h>
#include <algorithm>
#include <charconv>
#include <optional>

namespace muelle {

namespace {

/// Takes the first line off the text, without its end.
std::string_view takeLine(std::string_view& text) {
  const std::size_t end = std::min(text.find('\n'), text.size());
  const std::string_view line = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  return line;
}

std::string_view baseName(std::string_view path) {
  const std::size_t slash = path.rfind('/');
  return slash == std::string_view::npos ? path : path.substr(slash + 1);
}

struct Location {
  std::string_view file;
  int line = 0;
  int column = 0;
};

/// Takes ":12" off the end of the text.
std::optional<int> takeNumber(std::string_view& text) {
  const std::size_t colon = text.rfind(':');
  if (colon == std::string_view::npos || colon + 1 == text.size()) return std::nullopt;
  int number = 0;
  const auto [end, error] = std::from_chars(text.data() + colon + 1, text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  text = text.substr(0, colon);
  return number;
}

/// "dir/file.cpp:12:5", "dir/file.cpp:12", "cc1plus".
Location readLocation(std::string_view text) {
  Location location;
  const std::optional<int> last = takeNumber(text);
  const std::optional<int> first = last ? takeNumber(text) : std::nullopt;
  location.file = baseName(text);
  location.line = first ? *first : last.value_or(0);
  location.column = first ? *last : 0;
  return location;
}

/// "-Wuninitialized" at the end of "... [-Wuninitialized]"; "" when there is none.
std::string_view optionOf(std::string_view message) {
  const std::size_t open = message.rfind(" [-W");
  if (open == std::string_view::npos || !message.ends_with(']')) return {};
  return message.substr(open + 2, message.size() - open - 3);
}

/// Warnings of memory that is gone, was never written or is not theirs, and of a missing return.
bool isOfMemory(std::string_view option) {
  static constexpr std::string_view kinds[] = {"-Wreturn-type",   "-Wreturn-local-addr",   "-Wreturn-stack-address",
                                               "-Wdangling",      "-Wuse-after-free",      "-Wfree-nonheap-object",
                                               "-Wuninitialized", "-Wmaybe-uninitialized", "-Wsometimes-uninitialized",
                                               "-Warray-bounds",  "-Wstringop-over",       "-Waggressive-loop"};
  return std::ranges::any_of(kinds, [&](std::string_view kind) { return option.starts_with(kind); });
}

/// Those of what was never written.
bool isOfUnwritten(std::string_view option) { return option.find("uninitialized") != std::string_view::npos; }

/// What is wrong in every run stands first, what is only untidy last. 0 is the heaviest.
int weightOf(std::string_view option) {
  static constexpr std::string_view slips[] = {"-Wparentheses", "-Wconversion",  "-Wfloat",        "-Wint-in-bool",
                                               "-Wsign",        "-Wdiv-by-zero", "-Wbool",         "-Wlogical",
                                               "-Waddress",     "-Woverflow",    "-Wtautological", "-Wempty-body",
                                               "-Wmisleading",  "-Wsequence",    "-Wsizeof",       "-Wself-assign"};
  if (option.starts_with("-Wreturn-type")) return 0;
  if (isOfMemory(option)) return 1;
  if (std::ranges::any_of(slips, [&](std::string_view slip) { return option.starts_with(slip); })) return 2;
  return option.starts_with("-Wunused") ? 4 : 3;
}

enum class Kind { Error, Warning, Note };

struct Statement {
  Kind kind;
  Location location;
  std::string_view message;
};

/// "file:12:5: error: message", or nothing.
std::optional<Statement> readStatement(std::string_view line) {
  static constexpr std::pair<std::string_view, Kind> words[] = {{": fatal error: ", Kind::Error},
                                                                {": error: ", Kind::Error},
                                                                // The assembler's, of an asm in the file.
                                                                {": Fatal error: ", Kind::Error},
                                                                {": Error: ", Kind::Error},
                                                                {": warning: ", Kind::Warning},
                                                                {": note: ", Kind::Note}};
  for (const auto& [word, kind] : words) {
    const std::size_t at = line.find(word);
    if (at == std::string_view::npos || line.starts_with(' ')) continue;
    return Statement{kind, readLocation(line.substr(0, at)), line.substr(at + word.size())};
  }
  return std::nullopt;
}

/// "no match for 'operator-' in 'a - (long template) b' (operand types ...": the line of source says the middle better.
std::string withoutExpression(std::string_view message) {
  const std::size_t in = message.find("' in '");
  const std::size_t operands = message.rfind(" (operand type");
  const bool isOperator = contains(message, "no match for 'operator") && in != std::string_view::npos &&
                          operands != std::string_view::npos && in < operands;
  if (!isOperator) return std::string(message);
  return std::string(message.substr(0, in + 1)) + std::string(message.substr(operands));
}

/// Reads the compiler's text once from top to bottom.
class Reader {
 public:
  explicit Reader(const std::vector<StudentFile>& files) : files_(files) {}

  void read(std::string_view text) {
    while (!text.empty()) readLine(takeLine(text));
  }

  /// Errors, else warnings; one for each of the student's lines, because what follows on a line follows from it. Before
  /// the errors the characters that only look like C++: the rest mostly follows from them. Warnings by weight.
  std::vector<Diagnostic> result() const {
    const bool anyError = std::ranges::any_of(found_, &Diagnostic::isError);
    std::vector<Diagnostic> kept = anyError ? charactersAtFault() : std::vector<Diagnostic>();
    for (const Diagnostic& diagnostic : found_) {
      const bool isRepeated = std::ranges::any_of(
          kept, [&](const Diagnostic& d) { return d.file == diagnostic.file && d.line == diagnostic.line; });
      if (diagnostic.isError == anyError && !isRepeated) kept.push_back(diagnostic);
    }
    if (!anyError) std::ranges::stable_sort(kept, {}, [](const Diagnostic& d) { return weightOf(d.option); });
    return kept;
  }

  /// The first error that stands in no line of the student's; "" when there is none.
  const std::string& foreignError() const { return foreignError_; }

  /// All there is in the student's lines, in the compiler's order.
  const std::vector<Diagnostic>& found() const { return found_; }

 private:
  std::vector<Diagnostic> charactersAtFault() const {
    std::vector<Diagnostic> all;
    for (const StudentFile& file : files_) {
      const bool hasError =
          std::ranges::any_of(found_, [&](const Diagnostic& d) { return d.isError && d.file == file.name; });
      if (!hasError) continue;
      for (Diagnostic& each : oddCharacters(file)) all.push_back(std::move(each));
    }
    return all;
  }

  const StudentFile* studentFile(std::string_view name) const {
    const auto found = std::ranges::find(files_, name, &StudentFile::name);
    return found == files_.end() ? nullptr : &*found;
  }

  void readLine(std::string_view line) {
    if (contains(line, ": In instantiation of '") || contains(line, ": In substitution of '")) {
      context_.reset();
      mixed_ = matrixNamesIn(line);
    } else if (contains(line, "   required from here") || contains(line, ":   required by substitution")) {
      const Location location = readLocation(line.substr(0, line.find(":   required")));
      if (studentFile(location.file) != nullptr) context_ = location;
    } else if (line.starts_with("    inlined from '")) {
      // The outermost stands last, and is the student's own where the innermost is Eigen's.
      std::string_view place = line.substr(line.rfind("' at ") + 5);
      while (place.ends_with(':') || place.ends_with(',')) place.remove_suffix(1);
      const Location location = readLocation(place);
      if (studentFile(location.file) != nullptr && !inlinedAt_) inlinedAt_ = location;
    } else if (const std::optional<Statement> statement = readStatement(line)) {
      take(*statement);
      if (statement->kind != Kind::Note) inlinedAt_.reset();
    }
  }

  void take(const Statement& statement) {
    if (statement.kind == Kind::Note) return takeNote(statement);
    const bool isStudents = studentFile(statement.location.file) != nullptr;
    const bool isError = statement.kind == Kind::Error;
    const std::optional<Location>& leads = inlinedAt_ ? inlinedAt_ : context_;
    if (!isStudents && !leads) {
      // A warning outside of the student's file is none of theirs.
      if (isError && foreignError_.empty()) {
        foreignError_ = fmt::format("{}:{}: error: {}", statement.location.file, statement.location.line,
                                    withPlainTypes(statement.message));
      }
      return;
    }
    const Location place = isStudents ? statement.location : *leads;
    Diagnostic diagnostic{isError,
                          std::string(place.file),
                          place.line,
                          place.column,
                          withPlainTypes(withoutExpression(statement.message)),
                          explainMessage(statement.message, mixed_),
                          std::string(isError ? "" : optionOf(statement.message))};
    if (!isStudents && inlinedAt_ && isOfMemory(diagnostic.option)) explainInlined(diagnostic);
    if (contains(statement.message, "expected")) explainSemicolon(statement.message, diagnostic);
    shorten(diagnostic);
    found_.push_back(diagnostic);
  }

  /// GCC speaks of the registers into which Eigen loads; what the student has written is seldom in its words.
  void explainInlined(Diagnostic& diagnostic) const {
    diagnostic.message = fmt::format(
        "this reads memory that was never written, or that belonged to a temporary value which is gone [{}]",
        diagnostic.option);
    const bool hasAuto = isInFunctionOfLine(studentFile(diagnostic.file)->text, diagnostic.line, "auto");
    diagnostic.explanation =
        hasAuto ? "'auto' does not keep an Eigen expression's values: write the type (double, Vec3, VecX), and give it "
                  "a value"
                : "it is read before a value was given to it, or a temporary or local variable that is gone is used";
  }

  /// Notes that say where the other half of a contradiction stands.
  void takeNote(const Statement& statement) {
    if (found_.empty()) return;
    Diagnostic& diagnostic = found_.back();
    if (contains(statement.message, "previously defined here") || contains(statement.message, "previous definition")) {
      explainFirst(statement.location, diagnostic);
    }
    if (contains(statement.message, "did you forget to '#include")) {
      const std::size_t open = statement.message.find("#include");
      const std::string_view include = statement.message.substr(open, statement.message.find('>', open) + 1 - open);
      diagnostic.explanation = fmt::format("write {} at the top of the file", include);
    }
    if (contains(statement.message, "old declaration '") &&
        contains(diagnostic.message, "ambiguating new declaration")) {
      const std::string plain = withPlainTypes(statement.message);
      const std::size_t open = plain.find('\'') + 1;
      diagnostic.explanation += fmt::format(": {}", plain.substr(open, plain.rfind('\'') - open));
    }
  }

  /// Where the first of two definitions stands: in the file, or in a header that the student has not written.
  void explainFirst(const Location& first, Diagnostic& diagnostic) const {
    if (studentFile(first.file) != nullptr) {
      diagnostic.explanation += fmt::format(" (the first stands in line {})", first.line);
    } else if (contains(diagnostic.message, "redefinition of")) {
      const std::string_view name = first.file.substr(0, first.file.rfind('.'));
      const bool isContract = studentFile(std::string(name) + ".cpp") != nullptr;
      diagnostic.explanation = fmt::format("{}{} already defines it, in line {}: take yours out",
                                           isContract ? "the contract " : "", first.file, first.line);
    }
  }

  /// The compiler points at the word before which a semicolon is missing, often the first of the next line.
  void explainSemicolon(std::string_view message, Diagnostic& diagnostic) const {
    if (!contains(message, "';' before") && !contains(message, "expected ';'") &&
        !contains(message, "expected initializer before"))
      return;
    const StudentFile* file = studentFile(diagnostic.file);
    std::string_view text = file->text;
    std::string_view line;
    int lastFilled = 0;
    for (int number = 1; number <= diagnostic.line && !text.empty(); ++number) {
      line = takeLine(text);
      const bool isFilled = line.find_first_not_of(" \t\r}") != std::string_view::npos;
      if (number < diagnostic.line && isFilled) lastFilled = number;
    }
    const std::size_t start = std::min(line.find_first_not_of(" \t"), line.size());
    const bool pointsAtStart = static_cast<std::size_t>(std::max(diagnostic.column, 1)) <= start + 1;
    diagnostic.explanation = pointsAtStart && lastFilled > 0
                                 ? fmt::format("a semicolon is missing, most likely at the end of line {}", lastFilled)
                                 : "a semicolon is missing, most likely here";
  }

  /// What Eigen shouts, in words; and no message longer than a few lines.
  static void shorten(Diagnostic& diagnostic) {
    const std::string_view shout = "static assertion failed: ";
    if (diagnostic.message.starts_with(shout) && !diagnostic.explanation.empty()) {
      diagnostic.message = diagnostic.explanation;
      diagnostic.explanation.clear();
    }
    constexpr std::size_t longest = 300;
    if (diagnostic.message.size() > longest) diagnostic.message = diagnostic.message.substr(0, longest) + " ...";
  }

  const std::vector<StudentFile>& files_;
  std::optional<Location> context_;    ///< the student's line that led into the template at fault
  std::optional<Location> inlinedAt_;  ///< the student's line into which the function at fault was inlined
  std::vector<std::string> mixed_;     ///< the plain types in the name of that template
  std::vector<Diagnostic> found_;
  std::string foreignError_;
};

/// Line `number` of the text, from 1, and a caret below its column (in bytes).
std::string sourceLine(std::string_view text, int number, int column) {
  std::string_view line;
  for (int i = 0; i < number; ++i) {
    if (text.empty()) return "";
    line = takeLine(text);
  }
  constexpr std::size_t longest = 160;
  if (number < 1 || line.size() > longest) return "";
  std::string shown(line);
  std::string margin;
  for (std::size_t i = 0; i < shown.size(); ++i) {
    if (shown[i] == '\t' || shown[i] == '\r') shown[i] = ' ';
    const bool isContinuation = (static_cast<unsigned char>(shown[i]) & 0xC0U) == 0x80;
    if (static_cast<int>(i) + 1 < column && !isContinuation) margin += ' ';
  }
  const std::string caret = column > 0 ? fmt::format("      | {}^\n", margin) : "";
  return fmt::format("{:5} | {}\n{}", number, shown, caret);
}

}  // namespace

std::vector<std::string> diagnosticFlags() {
  return {"-fdiagnostics-color=never", "-fno-diagnostics-show-caret", "-fdiagnostics-column-unit=byte"};
}

std::vector<Diagnostic> parseDiagnostics(std::string_view compilerText, const std::vector<StudentFile>& files) {
  Reader reader(files);
  reader.read(compilerText);
  return reader.result();
}

bool warnsOfMemory(std::string_view compilerText, const std::vector<StudentFile>& files) {
  Reader reader(files);
  reader.read(compilerText);
  return std::ranges::any_of(reader.found(), [](const Diagnostic& d) { return isOfMemory(d.option); });
}

bool warnsOfUnwritten(std::string_view compilerText, const std::vector<StudentFile>& files) {
  Reader reader(files);
  reader.read(compilerText);
  return std::ranges::any_of(reader.found(), [](const Diagnostic& d) { return isOfUnwritten(d.option); });
}

std::string showDiagnostics(const std::vector<Diagnostic>& diagnostics, const std::vector<StudentFile>& files,
                            int limit) {
  std::string text;
  const std::size_t shown = std::min(diagnostics.size(), static_cast<std::size_t>(std::max(limit, 0)));
  for (std::size_t i = 0; i < shown; ++i) {
    const Diagnostic& d = diagnostics[i];
    const std::string column = d.column > 0 ? fmt::format(":{}", d.column) : "";
    text += fmt::format("{}:{}{}: {}: {}\n", d.file, d.line, column, d.isError ? "error" : "warning", d.message);
    const auto file = std::ranges::find(files, d.file, &StudentFile::name);
    if (file != files.end()) text += sourceLine(file->text, d.line, d.column);
    if (!d.explanation.empty()) text += fmt::format("      = {}\n", d.explanation);
  }
  const auto more = static_cast<long long>(diagnostics.size() - shown);
  if (more > 0 && shown > 0) {
    text += diagnostics.front().isError
                ? fmt::format("and {} more {}, which may go away with the first\n", more, nounFor(more, "error"))
                : fmt::format("and {} more {}\n", more, nounFor(more, "warning"));
  }
  return printableText(text);
}

std::string cutDiagnostics(std::string_view compilerText, const std::vector<StudentFile>& files) {
  Reader reader(files);
  reader.read(compilerText);
  const std::vector<Diagnostic> diagnostics = reader.result();
  const bool anyError = std::ranges::any_of(diagnostics, &Diagnostic::isError);
  if (anyError || reader.foreignError().empty()) return showDiagnostics(diagnostics, files);
  return printableText(reader.foreignError()) + "\n";
}

}  // namespace muelle
