#pragma once

// Sanitizers cannot run the code that picks a version: it runs before they are ready. g++ and clang name them
// differently.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define BERM_IS_SANITIZED 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define BERM_IS_SANITIZED 1
#endif
#endif

// BERM_MULTIVERSION before a function compiles it for several instruction sets and picks one when the program is
// loaded. As fused multiply-add is left out, all give the same bits.
#if defined(__x86_64__) && defined(__linux__) && !defined(BERM_IS_SANITIZED)
#define BERM_MULTIVERSION __attribute__((target_clones("avx2", "default")))
#else
#define BERM_MULTIVERSION
#endif
