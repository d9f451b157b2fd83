#pragma once
/// \file
/// The arguments of a call without their types: what history, mistakes and the search for simple calls work on. What an
/// argument's type is needed for stands in a table, one for each type and not for each function that takes it.

#include "course/testing/print_value.h"
#include "grader/remote/numbers.h"
#include "grader/testing/argument_items.h"

#include <memory>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace muelle::grader {

/// What is done to an argument of one type; see argument_items.h.
struct ArgumentKind {
  void (*appendItems)(std::vector<ArgumentItem>& items, const void* value, const Leaf& at);
  void (*appendNumbers)(std::vector<double>& numbers, const void* value);
  void (*changeAt)(void* value, const Leaf& leaf, const Change& change);
  void (*keepPart)(void* value, Part part);
  void (*takeFirstForAll)(void* value, const Leaf& leaf);
  void (*swap)(void* value, void* other);
  void (*assign)(void* value, const void* other);
  std::string (*print)(const void* value);
};

template <class T>
inline constexpr ArgumentKind argumentKind{
    [](std::vector<ArgumentItem>& items, const void* value, const Leaf& at) {
      appendItems(items, *static_cast<const T*>(value), at);
    },
    [](std::vector<double>& numbers, const void* value) { appendNumbers(numbers, *static_cast<const T*>(value)); },
    [](void* value, const Leaf& leaf, const Change& change) { changeAt(*static_cast<T*>(value), leaf, change); },
    [](void* value, Part part) { keepPart(*static_cast<T*>(value), part); },
    [](void* value, const Leaf& leaf) { takeFirstForAll(*static_cast<T*>(value), leaf); },
    [](void* value, void* other) { std::swap(*static_cast<T*>(value), *static_cast<T*>(other)); },
    [](void* value, const void* other) { *static_cast<T*>(value) = *static_cast<const T*>(other); },
    [](const void* value) { return printValue(*static_cast<const T*>(value)); }};

struct Argument {
  void* value;
  const ArgumentKind* kind;  ///< the same one for arguments of one type
};

/// The arguments of one call. Copies share them.
struct UntypedArguments {
  std::shared_ptr<void> tuple;  ///< a std::tuple of the types without references
  std::vector<Argument> list;   ///< where they stand in it

  /// Each as source.
  std::vector<std::string> texts() const;
};

template <class... Ts>
UntypedArguments withoutTypes(std::tuple<Ts...> typed) {
  auto tuple = std::make_shared<std::tuple<Ts...>>(std::move(typed));
  std::vector<Argument> list;
  std::apply([&list](Ts&... each) { list = {Argument{&each, &argumentKind<Ts>}...}; }, *tuple);
  return {std::move(tuple), std::move(list)};
}

/// f(a, b, c), as source.
std::string printCall(const std::string& function, const UntypedArguments& arguments);

}  // namespace muelle::grader
