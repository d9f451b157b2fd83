#pragma once
/// \file
/// A failed expectation as data: its numbers stay numbers until a page or a terminal shows them.

#include <optional>
#include <string>
#include <string_view>

namespace muelle {

/// What a failed expectation found. One of three: a number that is off (the default), a wrong size (the shapes differ),
/// or, where nothing was compared, a statement (`says`).
struct Mismatch {
  std::string label;  ///< what was compared in the student's words, "height at t = 0.35 s"; "" when the test has none
  std::string expression;  ///< what was compared as source, "springForce(xa, xb, k, L0)"
  bool ofCall = false;     ///< `expression` begins with the call itself: under its call it need not be said again
  std::string call;        ///< the latest call with its inputs, as source; "" when none was made
  long row = -1;           ///< of the entry that is off; -1 for a number
  long col = -1;           ///< as `row`
  long rows = 1;           ///< of what was expected
  long cols = 1;           ///< of what was expected
  long gotRows = 1;
  long gotCols = 1;
  double got = 0.0;        ///< the value that came, in `unit`; any bits
  double expected = 0.0;   ///< the value that should have come, in `unit`
  double tolerance = 0.0;  ///< absolute, in `unit`
  std::string unit;        ///< "m/s"; "" when the test names none
  std::string says;        ///< one line in place of all numbers, when nothing was compared

  bool isStatement() const { return !says.empty(); }
  bool isSize() const { return rows != gotRows || cols != gotCols; }
};

/// A mismatch in words, in parts for a page that sets them apart.
struct MismatchWords {
  std::string what;      ///< "springForce, component 2"; the statement when there is nothing else
  std::string got;       ///< "1.5 m", "2 components"; "" for a statement
  std::string expected;  ///< as `got`
  std::string bounds;    ///< "difference 0.5, tolerance 1e-09"; "" when it says nothing
};

/// The parts of a sentence.
MismatchWords wordsOf(const Mismatch& mismatch);

/// "springForce, component 2: got 1.5, expected 1 (difference 0.5, tolerance 1e-09)": the only place
/// where a sentence is made of a mismatch. Not made printable: a statement may hold a student's text.
std::string sentence(const Mismatch& mismatch);

/// The source of a test as a student writes it: without the "submission::" that tells their functions from the
/// oracle's.
std::string asStudentsWrite(std::string source);

/// Leaves a mismatch, or none, for the listener that is told of the failure next on this thread.
void noteMismatch(std::optional<Mismatch> mismatch);

/// Takes the noted mismatch when it is what `message`, GoogleTest's, begins with; nullopt when the failure is another.
std::optional<Mismatch> takeMismatch(std::string_view message);

/// Names what the expectations of a scope compare, and its unit. See MUELLE_LABEL.
class MismatchLabel {
 public:
  explicit MismatchLabel(std::string label, std::string unit = "");
  MismatchLabel(const MismatchLabel&) = delete;
  MismatchLabel& operator=(const MismatchLabel&) = delete;
  ~MismatchLabel();

  const std::string& label() const { return label_; }
  const std::string& unit() const { return unit_; }

  /// The innermost of this thread, or null.
  static const MismatchLabel* current();

 private:
  std::string label_;
  std::string unit_;
  const MismatchLabel* outer_;
};

}  // namespace muelle
