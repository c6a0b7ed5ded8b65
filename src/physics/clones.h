#pragma once

// On a function whose loops run over the 16 lanes of a packet: it is compiled a second time, for
// AVX-512, with all that it calls in it, and the program takes the one for its processor when it
// starts (as Embree does with its kernels). Both give the same bits: no operation is fused or
// approximated in either. Sanitizers do not bear the choice before they have begun.
#if defined(__GNUC__) && !defined(__clang__) && defined(__AVX2__) && !defined(__AVX512F__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define RESTFRAME_CLONES __attribute__((target_clones("arch=x86-64-v4", "default"), flatten))
#else
#define RESTFRAME_CLONES
#endif
