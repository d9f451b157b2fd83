#pragma once
/// \file
/// A function's arguments taken apart into numbers, each with its place, and changed there: what the types of the
/// arguments are needed for. Everything else about mistakes is no template.

#include "course/testing/struct_fields.h"
#include "grader/evidence.h"
#include "harness/types.h"

#include <concepts>
#include <functional>
#include <type_traits>
#include <vector>

namespace muelle::grader {

/// What stands at one place of the arguments.
struct ArgumentItem {
  enum class Kind {
    Number,  ///< one number
    Whole,   ///< one whole number
    Vector,  ///< a vector of fixed length: a place, a direction, nodes stacked
    Stack,   ///< a vector of run-time length: numbers, of which no length or distance is asked
    List,    ///< a list: its length alone; its numbers follow as items of their own
    Field    ///< the numbers of one field of a list's structs, or of a list of numbers
  };
  Leaf leaf;
  Kind kind = Kind::Number;
  std::vector<double> numbers;
};

/// Vectors of up to so many numbers are taken apart; longer ones are stacked nodes, three numbers each.
inline constexpr std::size_t mostComponents = 3;

/// What is done to each number at a place.
using Change = std::function<double(double)>;

template <class T>
constexpr bool isVector = false;
template <int Rows, int Options>
constexpr bool isVector<Eigen::Matrix<double, Rows, 1, Options>> = true;

template <class T>
constexpr bool isOfFixedLength = isVector<T>;
template <int Options>
constexpr bool isOfFixedLength<Eigen::Matrix<double, Eigen::Dynamic, 1, Options>> = false;

template <class T>
constexpr bool isList = false;
template <class T>
constexpr bool isList<std::vector<T>> = true;

/// Applies `change` to the number, or to all numbers, at `leaf` of one argument.
template <class T>
void changeAt(T& value, const Leaf& leaf, const Change& change) {
  if constexpr (std::same_as<T, double>) {
    value = change(value);
  } else if constexpr (isVector<T>) {
    for (Eigen::Index i = 0; i < value.size(); ++i) {
      if (leaf.component < 0 || leaf.component == i) value[i] = change(value[i]);
    }
  } else if constexpr (isList<T>) {
    for (auto& each : value) changeAt(each, leaf, change);
  } else if constexpr (DescribedStruct<T>) {
    int field = 0;
    visitFields(value, [&](auto& each) {
      if (field++ == leaf.field) changeAt(each, {leaf.argument, -1, leaf.component}, change);
    });
  }
}

template <class T>
void appendItems(std::vector<ArgumentItem>& items, const T& value, const Leaf& at);

/// A member of a list, with numbers that may be read.
template <class T>
T memberOfZeros() {
  T member{};
  if constexpr (isVector<T>) member.setZero();
  return member;
}

/// Of a list each field by itself, over all its members.
template <class T>
void appendFields(std::vector<ArgumentItem>& items, const std::vector<T>& list, const Leaf& at) {
  std::vector<ArgumentItem> ofOne;
  appendItems(ofOne, memberOfZeros<T>(), at);
  for (const ArgumentItem& each : ofOne) {
    ArgumentItem field{each.leaf, ArgumentItem::Kind::Field, {}};
    for (T member : list) {
      changeAt(member, each.leaf, [&field](double number) {
        field.numbers.push_back(number);
        return number;
      });
    }
    items.push_back(std::move(field));
  }
}

/// The items of one argument.
template <class T>
void appendItems(std::vector<ArgumentItem>& items, const T& value, const Leaf& at) {
  using Kind = ArgumentItem::Kind;
  if constexpr (std::same_as<T, double>) {
    items.push_back({at, Kind::Number, {value}});
  } else if constexpr (std::integral<T>) {
    items.push_back({at, Kind::Whole, {static_cast<double>(value)}});
  } else if constexpr (isVector<T>) {
    const Kind kind = isOfFixedLength<T> ? Kind::Vector : Kind::Stack;
    items.push_back({at, kind, {value.data(), value.data() + value.size()}});
  } else if constexpr (isList<T>) {
    items.push_back({at, Kind::List, {static_cast<double>(value.size())}});
    appendFields(items, value, at);
  } else if constexpr (DescribedStruct<T>) {
    int field = 0;
    visitFields(value, [&](const auto& each) { appendItems(items, each, {at.argument, field++, -1}); });
  }
}

/// A part of a list.
enum class Part { WithoutFirst, WithoutLast, First, Last };

/// Leaves the part of a list; everything else, and an empty list, is as it was.
template <class T>
void keepPart(T& value, Part part) {
  if constexpr (isList<T>) {
    if (value.empty()) return;
    if (part == Part::WithoutFirst) value.erase(value.begin());
    if (part == Part::WithoutLast) value.pop_back();
    if (part == Part::First) value.erase(value.begin() + 1, value.end());
    if (part == Part::Last) value.erase(value.begin(), value.end() - 1);
  }
}

/// One change to the arguments of a call: numbers at a place, or a part of a list.
struct Edit {
  Leaf leaf;
  Change change;            ///< of the numbers at `leaf`; or empty:
  Part part = Part::First;  ///< of the list that is argument `leaf.argument`
};

/// Gives all members of a list the first one's numbers at `leaf`.
template <class T>
void takeFirstForAll(T& value, const Leaf& leaf) {
  if constexpr (isList<T>) {
    if (value.empty()) return;
    std::vector<double> first;
    auto front = value.front();
    changeAt(front, leaf, [&first](double number) {
      first.push_back(number);
      return number;
    });
    std::size_t next = 0;
    changeAt(value, leaf, [&](double) { return first[next++ % first.size()]; });
  }
}

}  // namespace muelle::grader
