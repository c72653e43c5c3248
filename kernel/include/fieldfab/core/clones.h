/// Functions compiled for more than one instruction set, of which the machine's best is taken when a program starts.
#pragma once

// Clang 16 has no clones of function templates, and none are needed where there is no AVX2.
#if defined(__x86_64__) && !defined(__clang__)
#define FIELDFAB_CLONES __attribute__((target_clones("avx2", "default")))
#else
#define FIELDFAB_CLONES
#endif
