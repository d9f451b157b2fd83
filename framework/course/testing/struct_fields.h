#pragma once
/// \file
/// MUELLE_STRUCT for the programs that print or transport structs: a visitor over the named fields.

#include "harness/for_each.h"

#include <type_traits>

#define MUELLE_VISIT_FIELD_(object, field) visit(object.field);

/// Defines structName(Type*) and visitFields(object, visitor), both found by argument-dependent lookup.
#define MUELLE_STRUCT(Type, ...)                                                \
  [[maybe_unused]] inline const char* structName(const Type*) { return #Type; } \
  template <class Object, class Visitor>                                        \
  requires std::is_same_v<std::remove_const_t<Object>, Type>                    \
  void visitFields(Object& object, Visitor&& visit) { MUELLE_FOR_EACH_WITH(MUELLE_VISIT_FIELD_, object, __VA_ARGS__) }

namespace muelle {

/// A type that MUELLE_STRUCT has described.
template <class T>
concept DescribedStruct = requires(const T* pointer) {
  structName(pointer);
};

}  // namespace muelle
