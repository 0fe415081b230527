# Compile options as one INTERFACE target, so that nothing of ours leaks into the projects that use berm.
add_library(berm_options INTERFACE)
target_compile_features(berm_options INTERFACE cxx_std_20)
# Contracting a*b+c into one rounding would make results depend on the compiler and the processor.
target_compile_options(berm_options INTERFACE -ffp-contract=off)
target_compile_options(berm_options INTERFACE
  $<BUILD_INTERFACE:-Wall;-Wextra;-Wpedantic;-Wshadow;-Wconversion;-Wsign-conversion;-Wnon-virtual-dtor;-Woverloaded-virtual;-Wno-missing-field-initializers>
  $<$<BOOL:${BERM_DEVELOPER}>:-Werror>)

if(BERM_SANITIZE)
  add_compile_options(-fsanitize=${BERM_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  add_link_options(-fsanitize=${BERM_SANITIZE})
endif()
if(BERM_BUILD_FUZZ)
  add_compile_options(-fsanitize=fuzzer-no-link)
endif()
