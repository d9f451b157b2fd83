#pragma once
/// \file
/// Mistakes that show in the numbers alone, whatever the exercise: every number that came is the same multiple of the
/// right one. They are named by `check` and by `grade`, in the words that the exercise's manifest has for them. What
/// needs more than the numbers (another formula for the same arguments) is an exercise's own.

#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace muelle {

/// What every number is multiplied with in the mistake of that id: "wrong_sign", "halved", ..., or an id that ends in
/// one of these ("plane_wrong_sign"); nullopt for an exercise's own mistake.
std::optional<double> commonFactor(std::string_view id);

/// The numbers that one function has returned, held against the right ones.
class Answers {
 public:
  /// \param got, expected as many numbers   \param tolerance absolute, of each
  void add(std::span<const double> got, std::span<const double> expected, double tolerance);

  /// The factor of commonFactor() that explains every number, right and wrong ones, when at least `fewestWrong` of them
  /// are wrong; else nullopt.
  std::optional<double> factor() const;

  static constexpr int fewestWrong = 2;

 private:
  std::map<double, bool> isRefuted_;  ///< by factor
  int wrong_ = 0;
};

/// Of this process, by function: what the expectations (expect.h) have compared of calls alone.
std::map<std::string, Answers>& comparedAnswers();

/// Takes note of a comparison whose left side is one call and nothing else: "submission::springForce(xa, xb, k, L0)".
void noteComparison(std::string_view source, std::span<const double> got, std::span<const double> expected,
                    double tolerance);

}  // namespace muelle
