#pragma once
#include <functional>
#include <string>
#include <vector>

namespace muelle::published {

/// One number of a published problem, in the source's units.
struct Quantity {
  std::string what;     ///< "y1 at 1.3 s"
  std::string unit;     ///< "" for none
  std::string printed;  ///< as the source has it: "14.48", "3.575e-2"
  /// From a formula in closed form, evaluated here, or from an independent solution in many digits.
  double exact = 0.0;
  /// How far the engine's value may be off the exact one, relative: what the model replaces (a rod by a stiff spring)
  /// and what the method does.
  double tolerance = 1e-8;
  /// The printed value is not the exact one, rounded: it is off by more than half of its last digit.
  bool printedIsOff = false;

  double printedValue() const;
  /// One unit of the last digit printed: 0.01 of "14.48".
  double lastDigit() const;
};

/// A spring-mass problem of a verification manual or a textbook, with the numbers that are printed there.
struct Problem {
  std::string id;       ///< the manual's: "VM182"
  std::string title;    ///< ours
  std::string source;   ///< manual, number, and the book that it cites
  std::string setting;  ///< what is given, in the source's units
  std::string model;    ///< how it is put here; empty: as it stands
  std::vector<Quantity> quantities;
  std::function<std::vector<double>()> solve;  ///< the engine's values, one a quantity
};

/// All problems, by kind: frequencies, motions, large deflections and contact.
std::vector<Problem> problems();

std::vector<Problem> frequencyProblems();
std::vector<Problem> motionProblems();
std::vector<Problem> nonlinearProblems();

}  // namespace muelle::published
