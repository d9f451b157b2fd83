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

/// What a factor does, in words that hold whatever its cause: "springForce gives the right size with the wrong sign, in
/// every call". "" for a factor that is no common mistake's.
std::string factorSentence(double factor, std::string_view function);

/// "nodeAcceleration is off by 9.81 in every call: a term is missing, or has the wrong sign".
std::string differenceSentence(double difference, std::string_view function);

/// The numbers that one function has returned, held against the right ones.
class Answers {
 public:
  /// \param got, expected as many numbers   \param tolerance absolute, of each
  void add(std::span<const double> got, std::span<const double> expected, double tolerance);

  /// The factor of commonFactor() that explains every number, right and wrong ones, when at least `fewestWrong` of them
  /// are wrong; else nullopt.
  std::optional<double> factor() const;

  /// By how much every number that is wrong is off, always the same, where the right ones are not the same; nullopt
  /// when fewer than `fewestWrong` are wrong, or they are off by this and that.
  std::optional<double> difference() const;

  static constexpr int fewestWrong = 2;

 private:
  void addWrong(double got, double expected, double tolerance);

  std::map<double, bool> isRefuted_;  ///< by factor
  std::optional<double> difference_;  ///< of the first wrong number
  double firstExpected_ = 0.0;        ///< beside it
  bool hasOneDifference_ = true;
  bool areRightOnesDifferent_ = false;
  int wrong_ = 0;
};

/// Of this process, by function: what the expectations (expect.h) have compared of calls alone.
std::map<std::string, Answers>& comparedAnswers();

/// Takes note of a comparison whose left side is one call and nothing else: "submission::springForce(xa, xb, k, L0)".
void noteComparison(std::string_view source, std::span<const double> got, std::span<const double> expected,
                    double tolerance);

}  // namespace muelle
