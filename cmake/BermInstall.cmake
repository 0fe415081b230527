# Installs headers, libraries, program and machines, and what find_package(berm COMPONENTS core ground ...) needs.
# Every module is a component with its own export file, so that who uses core alone needs Eigen alone.
include(CMakePackageConfigHelpers)

set(BERM_CMAKE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/berm)
get_property(BERM_MODULES GLOBAL PROPERTY BERM_MODULES)

# Package of find_package for every target of other projects that a module may link.
set(BERM_PACKAGE_OF_Eigen3::Eigen Eigen3)
set(BERM_PACKAGE_OF_Boost::headers Boost)
set(BERM_PACKAGE_OF_CLI11::CLI11 CLI11)
set(BERM_PACKAGE_OF_Ceres::ceres Ceres)
set(BERM_PACKAGE_OF_PNG::PNG PNG)
set(BERM_PACKAGE_OF_embree embree)
set(BERM_PACKAGE_OF_GDAL::GDAL GDAL)
set(BERM_PACKAGE_OF_GeographicLib::GeographicLib GeographicLib)
set(BERM_PACKAGE_OF_fmt::fmt fmt)
set(BERM_PACKAGE_OF_fmt::fmt-header-only fmt)
set(BERM_PACKAGE_OF_lzf::lzf lzf)
set(BERM_PACKAGE_OF_nlohmann_json::nlohmann_json nlohmann_json)
set(BERM_PACKAGE_OF_nanoflann::nanoflann nanoflann)
set(BERM_PACKAGE_OF_octomap octomap)
set(BERM_PACKAGE_OF_spdlog::spdlog spdlog)
set(BERM_PACKAGE_OF_Threads::Threads Threads)
set(BERM_PACKAGE_OF_tsl::robin_map tsl-robin-map)
set(BERM_PACKAGE_OF_yaml-cpp::yaml-cpp yaml-cpp)

set(BERM_COMPONENT_TABLE "")
foreach(module IN LISTS BERM_MODULES)
  get_target_property(depends berm_${module} BERM_DEPENDS)
  get_target_property(libraries berm_${module} BERM_LIBRARIES)
  list(REMOVE_ITEM libraries "")
  set(packages "")
  foreach(library IN LISTS libraries)
    if(NOT DEFINED BERM_PACKAGE_OF_${library})
      message(FATAL_ERROR "Module ${module} links ${library}: name its package in cmake/BermInstall.cmake")
    endif()
    list(APPEND packages ${BERM_PACKAGE_OF_${library}})
  endforeach()
  list(REMOVE_DUPLICATES packages)
  string(APPEND BERM_COMPONENT_TABLE
    "set(_berm_depends_${module} \"${depends}\")\nset(_berm_packages_${module} \"${packages}\")\n")

  install(TARGETS berm_${module} EXPORT berm_${module}
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
  install(EXPORT berm_${module} FILE berm-${module}.cmake NAMESPACE berm:: DESTINATION ${BERM_CMAKE_DIR})
endforeach()

# berm::berm is all modules at once.
add_library(berm_all INTERFACE)
add_library(berm::berm ALIAS berm_all)
set_target_properties(berm_all PROPERTIES EXPORT_NAME berm)
list(TRANSFORM BERM_MODULES PREPEND berm:: OUTPUT_VARIABLE BERM_MODULE_TARGETS)
target_link_libraries(berm_all INTERFACE ${BERM_MODULE_TARGETS})
install(TARGETS berm_all EXPORT berm_berm)
install(EXPORT berm_berm FILE berm-berm.cmake NAMESPACE berm:: DESTINATION ${BERM_CMAKE_DIR})

configure_package_config_file(cmake/bermConfig.cmake.in bermConfig.cmake INSTALL_DESTINATION ${BERM_CMAKE_DIR}
  PATH_VARS CMAKE_INSTALL_DATADIR)
write_basic_package_version_file(bermConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/bermConfig.cmake ${PROJECT_BINARY_DIR}/bermConfigVersion.cmake cmake/FindGeographicLib.cmake
  cmake/Findlzf.cmake
  DESTINATION ${BERM_CMAKE_DIR})
install(DIRECTORY include/berm DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
foreach(kind machines sensors scenarios)
  install(DIRECTORY ${kind}/ DESTINATION ${CMAKE_INSTALL_DATADIR}/berm/${kind} FILES_MATCHING PATTERN "*.yaml")
endforeach()
install(DIRECTORY web/dist/ DESTINATION ${CMAKE_INSTALL_DATADIR}/berm/web)
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})
if(TARGET berm)
  install(TARGETS berm RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
endif()
