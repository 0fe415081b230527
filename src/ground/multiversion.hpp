#pragma once

// BERM_MULTIVERSION before a function compiles it for several instruction sets and picks one when the program is
// loaded. As fused multiply-add is left out, all give the same bits. Sanitizers cannot run the code that picks.
#if defined(__x86_64__) && defined(__linux__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define BERM_MULTIVERSION __attribute__((target_clones("avx2", "default")))
#else
#define BERM_MULTIVERSION
#endif
