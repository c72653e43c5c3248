/// Function multiversioning: the compiler makes one version for each instruction set, and the loader chooses the best
/// one that the processor supports.
#pragma once

// Clang 16 has no clones of function templates, and none are needed where there is no AVX2.
#if defined(__x86_64__) && !defined(__clang__)
#define FIELDFAB_CLONES __attribute__((target_clones("avx2", "default")))
#else
#define FIELDFAB_CLONES
#endif
