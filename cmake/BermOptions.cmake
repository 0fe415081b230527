# Compile options as one INTERFACE target, so that nothing of ours leaks into the projects that use berm.
add_library(berm_options INTERFACE)
target_compile_features(berm_options INTERFACE cxx_std_20)
# Contracting a*b+c into one rounding would make results depend on the compiler and the processor.
target_compile_options(berm_options INTERFACE -ffp-contract=off)
target_compile_options(berm_options INTERFACE
  $<BUILD_INTERFACE:-Wall;-Wextra;-Wpedantic;-Wshadow;-Wconversion;-Wsign-conversion;-Wnon-virtual-dtor;-Woverloaded-virtual;-Wno-missing-field-initializers>
  $<$<BOOL:${BERM_DEVELOPER}>:-Werror>)
# g++ 12 sees overlapping copies in std::string that are not there (GCC bug 105651).
target_compile_options(berm_options INTERFACE
  $<BUILD_INTERFACE:$<$<AND:$<CXX_COMPILER_ID:GNU>,$<VERSION_LESS:$<CXX_COMPILER_VERSION>,13>>:-Wno-restrict>>)

# Instrumentation is for everything that is built here: half of it would miss the other half.
if(BERM_SANITIZE)
  add_compile_options(-fsanitize=${BERM_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  add_link_options(-fsanitize=${BERM_SANITIZE})
endif()
if(BERM_BUILD_FUZZ)
  add_compile_options(-fsanitize=fuzzer-no-link)
endif()
if(BERM_COVERAGE)
  # Atomic counters: tests run algorithms on several threads.
  add_compile_options(--coverage -fprofile-update=atomic)
  add_link_options(--coverage)
endif()

find_program(BERM_CCACHE ccache DOC "Compiler cache, used if it is there")
mark_as_advanced(BERM_CCACHE)
if(PROJECT_IS_TOP_LEVEL AND BERM_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${BERM_CCACHE})
endif()
