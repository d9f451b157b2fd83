#include "course/check/standard_message.h"

#include "base/text/words.h"

#include <array>

namespace muelle {

namespace {

/// The container whose member asserts; "container" when it is none of the usual ones.
std::string container(std::string_view prettyFunction) {
  // The member's own class stands before its parameters, after the return type; the first name of these is it.
  constexpr std::array<std::pair<std::string_view, std::string_view>, 8> names{{{"std::vector<", "std::vector"},
                                                                                {"std::array<", "std::array"},
                                                                                {"std::span<", "std::span"},
                                                                                {"basic_string", "std::string"},
                                                                                {"std::deque<", "std::deque"},
                                                                                {"std::optional<", "std::optional"},
                                                                                {"std::unique_ptr<", "std::unique_ptr"},
                                                                                {"shared_ptr", "std::shared_ptr"}}};
  for (const auto& [part, name] : names) {
    if (contains(prettyFunction, part)) return std::string(name);
  }
  return "container";
}

}  // namespace

std::string standardMessage(std::string_view condition, std::string_view prettyFunction) {
  const std::string name = container(prettyFunction);
  if (contains(condition, "__n < ") || contains(condition, "__pos <"))
    return "used an index beyond the end of a " + name;
  if (contains(condition, "empty()")) return "asked an empty " + name + " for an element";
  if (contains(condition, "_M_is_engaged") || contains(condition, "nullptr") || contains(condition, "pointer()")) {
    return "used a " + name + " that holds nothing";
  }
  return "broke a rule of " + name + ": '" + std::string(condition) + "' does not hold";
}

}  // namespace muelle
