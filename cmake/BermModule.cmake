# berm_module(NAME SOURCES ... [DEPENDS modules...] [PUBLIC targets...] [PRIVATE targets...])
#
# One library per module: public headers in include/berm/NAME, bodies and private headers in src/NAME.
# DEPENDS names other modules of berm; scripts/check_includes.py holds the includes to the same table.
# What was given stays in properties of the target: BermInstall.cmake makes the components of find_package of it.
function(berm_module name)
  cmake_parse_arguments(ARG "" "" "SOURCES;DEPENDS;PUBLIC;PRIVATE" ${ARGN})
  add_library(berm_${name} ${ARG_SOURCES})
  add_library(berm::${name} ALIAS berm_${name})
  set_target_properties(berm_${name} PROPERTIES
    EXPORT_NAME ${name} POSITION_INDEPENDENT_CODE ON
    BERM_DEPENDS "${ARG_DEPENDS}" BERM_LIBRARIES "${ARG_PUBLIC};${ARG_PRIVATE}")
  target_include_directories(berm_${name}
    PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>
    PRIVATE ${CMAKE_CURRENT_SOURCE_DIR})
  target_compile_features(berm_${name} PUBLIC cxx_std_20)
  list(TRANSFORM ARG_DEPENDS PREPEND berm::)
  target_link_libraries(berm_${name}
    PUBLIC ${ARG_DEPENDS} ${ARG_PUBLIC}
    PRIVATE $<BUILD_INTERFACE:berm_options> ${ARG_PRIVATE})
  set_property(GLOBAL APPEND PROPERTY BERM_MODULES ${name})
endfunction()
