#pragma once
/// \file
/// What the calls of one criterion say about the mistakes that a function may hold: data, from the test process to the
/// pool, which alone sees all criteria.

#include <cstdint>
#include <map>
#include <string>
#include <tuple>
#include <vector>

namespace muelle::grader {

/// A number, or all numbers of one kind, among the arguments of a function.
struct Leaf {
  int argument = 0;    ///< which, from 0
  int field = -1;      ///< of a struct, or of every struct of a list; -1: there is none
  int component = -1;  ///< of a vector; -1: all of it
  bool operator==(const Leaf&) const = default;
  bool operator<(const Leaf& other) const {
    return std::tie(argument, field, component) < std::tie(other.argument, other.field, other.component);
  }
};

/// A mistake that a function may hold: one that the manifest lists, or one that any function may have.
struct Hypothesis {
  std::string id;  ///< "wrong_sign": of the manifest when `isListed`, else a word of generic_mistakes.h
  bool isListed = false;
  std::vector<Leaf> of;  ///< the arguments that it is about, if any
  double value = 0.0;    ///< the constant that stands in an argument's place, the component that is wrong
  bool isExact = true;   ///< it gives the submission's numbers to nine digits, not to six
  bool operator==(const Hypothesis&) const = default;
};

/// Something of a call's arguments that a mistake may depend on: a number, a length, a distance, a count.
struct Feature {
  std::string kind;      ///< "value", "length", "distance", "difference", "count", "least", "most"
  std::vector<Leaf> of;  ///< one or two
  bool operator==(const Feature&) const = default;
  bool operator<(const Feature& other) const { return std::tie(kind, of) < std::tie(other.kind, other.of); }
};

/// Between which values of a feature the answers were right, and between which they were wrong. A plain call is one in
/// which no number, length or distance is 0: where one is, many a mistake does not show.
struct FeatureRange {
  double fewestRight, mostRight, fewestWrong, mostWrong;
  double fewestPlain, mostPlain;  ///< of the right calls that are plain
  bool operator==(const FeatureRange&) const = default;
};

/// A wrong answer, for authors who compare those of several hand-ins.
struct WrongAnswer {
  std::uint64_t question = 0;   ///< follows from the call's arguments: equal for equal ones
  std::vector<double> numbers;  ///< the first of them
  double roundOff = 0.0;        ///< where they cancel to nothing, this is left
  bool operator==(const WrongAnswer&) const = default;
};

/// A listed mistake among those of its function, for authors: which of them no call tells apart.
struct ListedMistake {
  std::string id;
  int group = 0;  ///< equal where the numbers agree in all calls; 0: those of the oracle
  bool operator==(const ListedMistake&) const = default;
};

/// The calls of one function.
struct FunctionEvidence {
  long calls = 0;
  long wrong = 0;            ///< calls with another answer than the oracle's, to six digits
  long imprecise = 0;        ///< calls with an answer near the oracle's, not equal: right to three to nine digits
  double worstNear = 0.0;    ///< largest deviation of these, relative to the oracle's answer
  long notANumber = 0;       ///< wrong calls with a NaN or an infinity in the answer
  long zero = 0;             ///< calls answered by nothing but zeros
  long wrongZero = 0;        ///< those among the wrong calls
  bool isUnwritten = false;  ///< memory to which nothing was written is among the answers
  bool isStateful = false;   ///< another answer to the same question, in the same process or in a fresh one
  bool isConstant = false;   ///< one answer to all calls, where the oracle has several
  std::vector<Hypothesis> agreeing;  ///< those that give the submission's answer in every call
  long plainRight = 0;               ///< right calls that are plain, see FeatureRange
  std::map<Feature, FeatureRange> features;
  std::vector<WrongAnswer> answers;   ///< a sample of the wrong ones; only GradeOptions::forAuthors, and not merged
  std::vector<ListedMistake> listed;  ///< in the order of their registration; likewise
  bool operator==(const FunctionEvidence&) const = default;
};

/// By function.
using Evidence = std::map<std::string, FunctionEvidence>;

}  // namespace muelle::grader
