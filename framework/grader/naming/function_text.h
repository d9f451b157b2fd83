#pragma once
#include <optional>
#include <string_view>

namespace muelle::grader {

/// A function's definition, cut out of a source.
struct FunctionText {
  std::string_view parameters;  ///< between the parentheses
  std::string_view body;        ///< between the braces
};

/// nullopt when the source does not define the function, or in a way that is not seen without compiling.
std::optional<FunctionText> functionText(std::string_view source, std::string_view function);

/// A function's declaration, cut out of a contract.
struct DeclarationText {
  std::string_view result;      ///< "Vec3"
  std::string_view parameters;  ///< between the parentheses
};

/// nullopt when the contract does not declare the function. Type and name stand in one line.
std::optional<DeclarationText> declarationText(std::string_view contract, std::string_view function);

}  // namespace muelle::grader
