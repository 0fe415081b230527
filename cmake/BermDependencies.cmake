# Everything here comes from the distribution's packages; scripts/setup.sh installs them.
find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(fmt REQUIRED)
find_package(spdlog REQUIRED)
find_package(CLI11 REQUIRED)
find_package(yaml-cpp REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(PNG REQUIRED)
find_package(embree REQUIRED)
find_package(lzf REQUIRED)
find_package(tsl-robin-map REQUIRED)

# yaml-cpp names its target differently from version to version.
if(NOT TARGET yaml-cpp::yaml-cpp)
  add_library(yaml-cpp::yaml-cpp ALIAS yaml-cpp)
endif()

if(BERM_BUILD_TESTS)
  find_package(GTest REQUIRED)
  find_package(rapidcheck REQUIRED)
endif()
if(BERM_BUILD_BENCH)
  find_package(benchmark REQUIRED)
endif()
