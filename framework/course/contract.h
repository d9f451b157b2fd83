#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace muelle {

/// A parameter of a function, as the contract declares it.
struct Parameter {
  std::string type;                 ///< "const std::vector<Attachment>&"
  std::string name;                 ///< "springs"
  std::vector<std::string> fields;  ///< of the struct that the type names, by MUELLE_STRUCT; empty when it names none
};

/// The parameters of a function of the contract, in order; empty when the contract does not declare it.
/// \param contract the text of the header
std::vector<Parameter> parametersOf(std::string_view contract, std::string_view function);

/// What a contract allows for a number, or for the length of a list, of that name: MUELLE_RANGE(k, 1e-3, 1e9).
struct Range {
  std::string name;  ///< of a parameter, or of a struct's field
  double least = 0.0;
  double most = 0.0;
};

/// The ranges that the contract states, in order. Throws std::runtime_error that names one whose numbers are none.
std::vector<Range> rangesOf(std::string_view contract);

/// The functions that the contract declares by MUELLE_FUNCTIONS, in order.
std::vector<std::string> functionsOf(std::string_view contract);

}  // namespace muelle
