// SPDX-License-Identifier: MIT
#pragma once

// Functions marked SCANBED_AVX2 are compiled for it whatever the rest is compiled for.
#if defined(__x86_64__) && defined(__GNUC__)
#define SCANBED_HAS_AVX2 1
#define SCANBED_AVX2 __attribute__((target("avx2")))
#else
#define SCANBED_AVX2
#endif

namespace scanbed {

/// What a loop that is compiled more than once runs on. All give the same bits, for nothing is fused.
enum class InstructionSet { kPlain, kAvx2 };

/// The widest that this CPU has and this program was compiled for.
inline InstructionSet widest_instruction_set() {
#if defined(SCANBED_HAS_AVX2)
  static const bool kHasAvx2 = __builtin_cpu_supports("avx2") != 0;
  if (kHasAvx2) return InstructionSet::kAvx2;
#endif
  return InstructionSet::kPlain;
}

}  // namespace scanbed
