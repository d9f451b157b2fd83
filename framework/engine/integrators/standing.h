#pragma once
#include <span>
#include <string_view>

namespace muelle::engine {

/// Why a method stands in the catalogue: one reason each, which a test looks up where it says. What has none goes.
struct Standing {
  enum class Because {
    Exercise,  ///< a student writes it: `where` is the exercise
    Figure,    ///< a figure of the lecture shows it: `where` is the figure
    Plane,     ///< it is the fastest of ours at an error of the plane: `where` is the scene of ./muelle bench
    Alone,     ///< no other has its order, stability and needs: `where` says what it is for
  };
  std::string_view id;
  Because because;
  std::string_view where = {};
};

/// Of every method, in the order of the catalogue.
std::span<const Standing> standings();

/// A method that was here.
struct GoneMethod {
  std::string_view id;
  std::string_view instead;  ///< the method to take now
  std::string_view why;      ///< with its figure, for the page of the methods
};

std::span<const GoneMethod> goneMethods();

}  // namespace muelle::engine
