include(GoogleTest)

# berm_test(NAME SOURCES ... LINK targets...): one test program per module, one ctest entry per test case.
function(berm_test name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LINK" ${ARGN})
  add_executable(${name} ${ARG_SOURCES})
  target_link_libraries(${name} PRIVATE berm_options ${ARG_LINK} GTest::gmock GTest::gtest_main rapidcheck)
  target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR}/tests)
  # Values would be bytes of memory where a parameter has no printer, others in every run.
  gtest_discover_tests(${name} NO_PRETTY_VALUES DISCOVERY_TIMEOUT 60 PROPERTIES TIMEOUT 600)
endfunction()

# For folders whose tests make worlds and scans by the million points: unlike other tests they run longer than they
# compile, so sanitizers get them with some optimisation.
macro(berm_heavy_tests)
  if(BERM_SANITIZE)
    add_compile_options(-O1)
  endif()
endmacro()
