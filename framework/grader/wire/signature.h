#pragma once
/// \file
/// What both ends of a remote call derive from a function's signature.

#include <cstdint>
#include <functional>
#include <string_view>
#include <type_traits>

namespace muelle::grader::wire {

/// Identifies a function of the contract on the wire (FNV-1a of its name).
constexpr std::uint32_t functionId(std::string_view name) {
  std::uint32_t hash = 2166136261U;
  for (const char c : name) hash = (hash ^ static_cast<unsigned char>(c)) * 16777619U;
  return hash;
}

/// A parameter that the function may change: its value travels back after the result.
template <class Parameter>
constexpr bool isOutParameter =
    std::is_lvalue_reference_v<Parameter> && !std::is_const_v<std::remove_reference_t<Parameter>>;

/// A parameter that is a function of the caller.
template <class T>
constexpr bool isCallback = false;
template <class Result, class... Args>
constexpr bool isCallback<std::function<Result(Args...)>> = true;

}  // namespace muelle::grader::wire
