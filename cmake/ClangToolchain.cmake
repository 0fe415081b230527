# Takes whatever clang the system has: fuzz targets need its libFuzzer, and it compiles sanitized code in half the time
# of g++. 16 first, as in scripts/common.sh.
find_program(BERM_CLANGXX NAMES clang++-16 clang++-17 clang++-18 clang++-15 clang++-14 clang++ REQUIRED
             DOC "Compiler of fuzz targets and asan-ubsan; scripts/setup.sh --dev installs it")
set(CMAKE_CXX_COMPILER ${BERM_CLANGXX})
