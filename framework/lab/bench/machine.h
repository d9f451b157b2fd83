#pragma once
#include <string>
#include <vector>

namespace muelle::bench {

/// Where numbers come from: what stands at the head of every page and file.
struct Machine {
  std::string processor;       ///< "AMD EPYC 9R14"
  std::string instructionSet;  ///< the widest that the processor has: "avx512", "avx2", "sse2" or another's name
  int cores = 0;               ///< that the system shows
  std::string compiler;        ///< "g++ 12.2.0"
  std::string flags;           ///< of the engine and of the peers' plain loops
  std::string system;          ///< "Linux 6.1"
  std::string date;            ///< "2026-11-29"

  /// Its folder's name: letters, digits and _ ("amd_epyc_9r14_avx512").
  std::string slug() const;
};

Machine thisMachine();

/// A hash of this program's own file and of the processor: what a record of runs belongs to.
std::string programStamp();

}  // namespace muelle::bench
