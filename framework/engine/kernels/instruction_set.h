#pragma once
#include <string_view>
#include <vector>

namespace muelle::engine::kernels {

/// What the kernels are compiled for. All of them give the same numbers to the last bit.
enum class InstructionSet {
  Baseline,  ///< SSE2 on x86-64; whatever the compiler makes of two lanes elsewhere
  Avx2,
  Avx512,  ///< F, VL and DQ
};

/// "baseline", "avx2" or "avx512".
const char* nameOf(InstructionSet set);

/// Whether this program has kernels for it and this processor can run them.
bool isAvailable(InstructionSet set);

/// All that are, from the baseline up.
std::vector<InstructionSet> availableInstructionSets();

/// The one in use: at first the widest that is available, or what the environment variable MUELLE_INSTRUCTION_SET
/// names. Throws std::invalid_argument where that is no name, or not available here.
InstructionSet instructionSet();

/// Sets the one in use, for tests and benchmarks. Throws std::invalid_argument where it is not available. Not to be
/// called while another thread is in a kernel.
void useInstructionSet(InstructionSet set);

/// The set of a name. Throws std::invalid_argument where there is none, or where it is not available.
InstructionSet instructionSetNamed(std::string_view name);

}  // namespace muelle::engine::kernels
