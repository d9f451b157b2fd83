#pragma once
#include "course/check/diagnostics.h"

#include <string>
#include <string_view>
#include <vector>

namespace muelle {

/// A file that is known to be good and asks of the machine what the student's files ask: it includes what they include
/// (<...>, the contract, the harness; a header that does not exist is passed over), in their order, and instantiates a
/// little of Eigen. It defines no function of the contract: an object file is made of it, and a library, no program.
/// \param contractName "spring_3d.h"
std::string probeSource(const std::vector<StudentFile>& files, std::string_view contractName);

}  // namespace muelle
