#include "engine/kernels/instruction_set.h"

#include "engine/kernels/kernel_table.h"
#include "engine/kernels/loops/tables.h"

#include <fmt/format.h>
#include <array>
#include <cstdlib>
#include <stdexcept>

namespace muelle::engine::kernels {

namespace {

constexpr std::array allSets = {InstructionSet::Baseline, InstructionSet::Avx2, InstructionSet::Avx512};

InstructionSet setAtFirst() {
  const char* wanted = std::getenv("MUELLE_INSTRUCTION_SET");
  if (wanted && *wanted) {
    try {
      return instructionSetNamed(wanted);
    } catch (const std::invalid_argument& error) {
      throw std::invalid_argument(fmt::format("environment variable MUELLE_INSTRUCTION_SET: {}", error.what()));
    }
  }
  return availableInstructionSets().back();
}

const Kernels& tableFor(InstructionSet set) {
#if defined(__x86_64__)
  if (set == InstructionSet::Avx512) return avx512Kernels();
  if (set == InstructionSet::Avx2) return avx2Kernels();
#else
  static_cast<void>(set);
#endif
  return baselineKernels();
}

struct Choice {
  InstructionSet set;
  const Kernels* table;
};

Choice& choice() {
  static Choice inUse = [] {
    const InstructionSet set = setAtFirst();
    return Choice{set, &tableFor(set)};
  }();
  return inUse;
}

std::string namesOfAvailable() {
  std::string names;
  for (const InstructionSet set : availableInstructionSets()) {
    if (!names.empty()) names += ", ";
    names += nameOf(set);
  }
  return names;
}

}  // namespace

const char* nameOf(InstructionSet set) {
  switch (set) {
    case InstructionSet::Avx2:
      return "avx2";
    case InstructionSet::Avx512:
      return "avx512";
    case InstructionSet::Baseline:
      break;
  }
  return "baseline";
}

bool isAvailable(InstructionSet set) {
  if (set == InstructionSet::Baseline) return true;
#if defined(__x86_64__)
  if (set == InstructionSet::Avx2) return __builtin_cpu_supports("avx2") != 0;
  return __builtin_cpu_supports("avx512f") != 0 && __builtin_cpu_supports("avx512vl") != 0 &&
         __builtin_cpu_supports("avx512dq") != 0;
#else
  return false;
#endif
}

std::vector<InstructionSet> availableInstructionSets() {
  std::vector<InstructionSet> available;
  for (const InstructionSet set : allSets) {
    if (isAvailable(set)) available.push_back(set);
  }
  return available;
}

InstructionSet instructionSetNamed(std::string_view name) {
  for (const InstructionSet set : allSets) {
    if (name != nameOf(set)) continue;
    if (isAvailable(set)) return set;
    throw std::invalid_argument(
        fmt::format("this processor cannot run the kernels for {}; take one of: {}", name, namesOfAvailable()));
  }
  throw std::invalid_argument(
      fmt::format("no instruction set is called \"{}\"; take one of: {}", name, namesOfAvailable()));
}

InstructionSet instructionSet() { return choice().set; }

void useInstructionSet(InstructionSet set) {
  if (!isAvailable(set)) instructionSetNamed(nameOf(set));  // throws, and says what there is
  choice() = {set, &tableFor(set)};
}

const Kernels& kernels() { return *choice().table; }

}  // namespace muelle::engine::kernels
