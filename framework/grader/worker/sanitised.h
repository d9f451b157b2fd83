#pragma once

namespace muelle::grader::worker {

/// True in the host that is linked with AddressSanitizer: its shadow memory wants an address space without a limit.
#ifdef MUELLE_SANITISED
inline constexpr bool isSanitised = true;
#else
inline constexpr bool isSanitised = false;
#endif

/// The host's argument with which fresh memory holds zeros, for a submission that is built with the other fill.
inline constexpr const char* refilledFlag = "refilled";

/// How the host tells what a sanitizer found from other causes of death: "sanitizer heap-buffer-overflow".
inline constexpr const char* sanitiserFinding = "sanitizer ";

}  // namespace muelle::grader::worker
