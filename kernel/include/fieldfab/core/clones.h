/// Function multiversioning: the compiler makes one version for each instruction set, and the loader chooses the best
/// one that the processor supports.
#pragma once

// Clang 16 has no clones of function templates, and none are needed where there is no AVX2. The loader chooses before
// the thread sanitizer is ready to watch it.
#if defined(__x86_64__) && !defined(__clang__) && !defined(__SANITIZE_THREAD__)
#define FIELDFAB_CLONES __attribute__((target_clones("avx2", "default")))
#else
#define FIELDFAB_CLONES
#endif
