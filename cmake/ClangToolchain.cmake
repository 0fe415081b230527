# Takes whatever clang the system has: fuzz targets need its libFuzzer. 16 first, as in scripts/common.sh.
find_program(BERM_CLANGXX NAMES clang++-16 clang++-17 clang++-18 clang++-15 clang++-14 clang++ REQUIRED
             DOC "Compiler of the fuzz targets; scripts/setup.sh --dev installs it")
set(CMAKE_CXX_COMPILER ${BERM_CLANGXX})
