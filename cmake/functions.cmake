# The build's own functions: packages, warnings, libraries with their tests.

# find_package with the Debian package in the error message. What is found here is named by
# `mapbed --version` and found again by programs that use an installed mapbed.
macro(mapbed_package name debian_package)
  find_package(${name} ${ARGN} QUIET)
  if(NOT ${name}_FOUND)
    message(FATAL_ERROR "${name} not found; install it with: apt-get install ${debian_package}")
  endif()
  set_property(GLOBAL APPEND PROPERTY mapbed_packages ${name})
  set(mapbed_version_of_${name} "${${name}_VERSION}")
  if(NOT mapbed_version_of_${name})
    set(mapbed_version_of_${name} "${${name}_VERSION_STRING}")
  endif()
  if(mapbed_version_of_${name})
    set_property(GLOBAL APPEND PROPERTY mapbed_library_versions "${name} ${mapbed_version_of_${name}}")
  endif()
endmacro()

# Headers of a library without a CMake package: makes the target name::name. Further words are for
# find_path.
function(mapbed_headers name header debian_package)
  find_path(${name}_INCLUDE_DIR ${header} ${ARGN})
  if(NOT ${name}_INCLUDE_DIR)
    message(FATAL_ERROR "${header} not found; install it with: apt-get install ${debian_package}")
  endif()
  add_library(${name}::${name} INTERFACE IMPORTED GLOBAL)
  target_include_directories(${name}::${name} SYSTEM INTERFACE ${${name}_INCLUDE_DIR})
endfunction()

# The same of a library that is linked besides.
function(mapbed_library_of name header debian_package)
  mapbed_headers(${name} ${header} ${debian_package})
  find_library(${name}_LIBRARY ${name})
  if(NOT ${name}_LIBRARY)
    message(FATAL_ERROR "lib${name} not found; install it with: apt-get install ${debian_package}")
  endif()
  target_link_libraries(${name}::${name} INTERFACE ${${name}_LIBRARY})
endfunction()

# What only the tests need: neither in `mapbed --version` nor needed by installed libraries.
macro(mapbed_test_package name debian_package)
  find_package(${name} ${ARGN} QUIET)
  if(NOT ${name}_FOUND)
    message(FATAL_ERROR "${name} not found; install it with: apt-get install ${debian_package}")
  endif()
endmacro()

add_library(mapbed_flags INTERFACE)
# Contraction off and no -march=native: results must not depend on the processor.
target_compile_options(mapbed_flags INTERFACE
  -Wall -Wextra -Wconversion -Wshadow -Wno-missing-field-initializers -ffp-contract=off
  $<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess>  # shows ccache the precompiled header
  $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>  # g++ 12 sees -Wrestrict in std::string
  $<$<CXX_COMPILER_ID:Clang>:-Wno-string-conversion>  # CHECK(!"why")
  $<$<BOOL:${MAPBED_WERROR}>:-Werror>)
add_library(mapbed::flags ALIAS mapbed_flags)
install(TARGETS mapbed_flags EXPORT mapbed)

# One precompiled header for all tests: GoogleTest and Eigen cost most of a test file's compile time.
if(MAPBED_TESTS)
  add_library(mapbed_test_flags INTERFACE)
  # Tests run for moments, so that compiling them well costs more than it saves.
  target_compile_options(mapbed_test_flags INTERFACE $<$<CONFIG:Release>:-O1> ${MAPBED_TEST_FLAGS})
  file(CONFIGURE OUTPUT ${CMAKE_BINARY_DIR}/test_pch.cpp CONTENT "")
  add_library(mapbed_test_pch STATIC ${CMAKE_BINARY_DIR}/test_pch.cpp)
  target_link_libraries(mapbed_test_pch PUBLIC
    mapbed::flags mapbed_test_flags GTest::gtest GTest::gmock Eigen3::Eigen)
  target_precompile_headers(mapbed_test_pch PRIVATE <gmock/gmock.h> <gtest/gtest.h> <Eigen/Dense>)
endif()

# The same for libraries. Only what others wrote: headers of ours are included by who needs them. That
# each source includes what it needs of the rest shows in the preset fuzz, which precompiles nothing.
# Twice, as g++ compiles all of a source at the level of its precompiled header.
if(MAPBED_PRECOMPILE)
  file(CONFIGURE OUTPUT ${CMAKE_BINARY_DIR}/library_pch.cpp CONTENT "")
  foreach(pch mapbed_library_pch mapbed_hot_library_pch)
    add_library(${pch} STATIC ${CMAKE_BINARY_DIR}/library_pch.cpp)
    set_target_properties(${pch} PROPERTIES POSITION_INDEPENDENT_CODE ON)
    target_link_libraries(${pch} PUBLIC mapbed::flags Eigen3::Eigen fmt::fmt)
    target_precompile_headers(${pch} PRIVATE <algorithm> <cmath> <filesystem> <functional>
      <map> <memory> <optional> <span> <string> <variant> <vector> <Eigen/Dense> <fmt/format.h>)
  endforeach()
  target_compile_options(mapbed_hot_library_pch PRIVATE $<$<CONFIG:Release>:-O3>)
endif()

# All tests with the label unit. Each build has a folder of its own for temporary files, so that
# the tests of two builds can run at a time.
if(MAPBED_TESTS)
  set(mapbed_test_environment "TMPDIR=${CMAKE_BINARY_DIR}/test_files")
  file(MAKE_DIRECTORY ${CMAKE_BINARY_DIR}/test_files)
  add_custom_target(mapbed_unit_tests)
endif()

# mapbed_tests(cli LABEL cli SOURCES a_test.cpp … LINKS … PROPERTIES …) makes the program
# mapbed_cli_tests, and a test of ctest for each TEST in it, with that label and properties.
function(mapbed_tests name)
  cmake_parse_arguments(ARG "" "LABEL" "SOURCES;LINKS;PROPERTIES" ${ARGN})
  set(program mapbed_${name}_tests)
  add_executable(${program} ${ARG_SOURCES})
  target_precompile_headers(${program} REUSE_FROM mapbed_test_pch)
  target_link_libraries(${program} PRIVATE ${ARG_LINKS} mapbed::testing mapbed::flags mapbed_test_flags
    GTest::gtest GTest::gmock GTest::gmock_main)
  include(GoogleTest)
  gtest_discover_tests(${program} DISCOVERY_MODE PRE_TEST DISCOVERY_TIMEOUT 120
    PROPERTIES LABELS ${ARG_LABEL} ENVIRONMENT "${mapbed_test_environment}" ${ARG_PROPERTIES})
endfunction()

# mapbed_library(core SOURCES a.cpp … TESTS a_test.cpp … TEST_LINKS … PUBLIC_LINKS … PRIVATE_LINKS …)
# makes mapbed_core (alias mapbed::core) and, where tests are built, mapbed_core_tests. HOT: its inner
# loops are most of a run's time.
function(mapbed_library name)
  cmake_parse_arguments(ARG "HOT" "" "SOURCES;TESTS;TEST_LINKS;PUBLIC_LINKS;PRIVATE_LINKS" ${ARGN})
  add_library(mapbed_${name} STATIC ${ARG_SOURCES})
  add_library(mapbed::${name} ALIAS mapbed_${name})
  set_target_properties(mapbed_${name} PROPERTIES EXPORT_NAME ${name} POSITION_INDEPENDENT_CODE ON)
  target_compile_features(mapbed_${name} PUBLIC cxx_std_20)
  target_include_directories(mapbed_${name} PUBLIC
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/mapbed>)
  target_link_libraries(mapbed_${name} PUBLIC ${ARG_PUBLIC_LINKS} PRIVATE mapbed::flags ${ARG_PRIVATE_LINKS})
  set(pch mapbed_library_pch)
  if(ARG_HOT)
    set(pch mapbed_hot_library_pch)
    target_compile_options(mapbed_${name} PRIVATE $<$<CONFIG:Release>:-O3>)
  endif()
  if(MAPBED_PRECOMPILE)
    target_precompile_headers(mapbed_${name} REUSE_FROM ${pch})
    # The header holds fmt, which must be found as it was precompiled by libraries without it too.
    target_compile_definitions(mapbed_${name} PRIVATE
      $<TARGET_PROPERTY:fmt::fmt,INTERFACE_COMPILE_DEFINITIONS>)
  endif()
  install(TARGETS mapbed_${name} EXPORT mapbed)
  file(RELATIVE_PATH folder ${PROJECT_SOURCE_DIR} ${CMAKE_CURRENT_SOURCE_DIR})
  install(DIRECTORY ./ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/mapbed/${folder}
    FILES_MATCHING PATTERN "*.h" PATTERN testing EXCLUDE PATTERN testdata EXCLUDE)
  if(MAPBED_TESTS AND ARG_TESTS)
    mapbed_tests(${name} LABEL unit SOURCES ${ARG_TESTS} LINKS mapbed::${name} ${ARG_TEST_LINKS})
    add_dependencies(mapbed_unit_tests mapbed_${name}_tests)
  endif()
endfunction()

# What find_package(mapbed) reads; it looks for the same packages as this build did.
function(mapbed_install_package)
  include(CMakePackageConfigHelpers)
  get_property(packages GLOBAL PROPERTY mapbed_packages)
  list(REMOVE_DUPLICATES packages)
  list(TRANSFORM packages REPLACE "(.+)" "find_dependency(\\1)")
  list(JOIN packages "\n" find_dependencies)
  set(folder ${CMAKE_INSTALL_LIBDIR}/cmake/mapbed)
  configure_package_config_file(cmake/mapbed-config.cmake.in ${CMAKE_BINARY_DIR}/mapbed-config.cmake
    INSTALL_DESTINATION ${folder})
  write_basic_package_version_file(${CMAKE_BINARY_DIR}/mapbed-config-version.cmake
    COMPATIBILITY SameMinorVersion)
  install(FILES ${CMAKE_BINARY_DIR}/mapbed-config.cmake ${CMAKE_BINARY_DIR}/mapbed-config-version.cmake
    DESTINATION ${folder})
  install(EXPORT mapbed NAMESPACE mapbed:: FILE mapbed-targets.cmake DESTINATION ${folder})
endfunction()

# mapbed_fuzz_target(file/csv_file_fuzz.cpp SOURCES … LINKS mapbed::core) makes a libFuzzer program and a test
# (label fuzz) that starts from the files of file/testdata/csv_file_fuzz. Only in the preset `fuzz`; the file
# defines LLVMFuzzerTestOneInput. SOURCES: what it needs of a library that is too large to link.
function(mapbed_fuzz_target file)
  if(NOT MAPBED_FUZZ)
    return()
  endif()
  cmake_parse_arguments(ARG "" "" "SOURCES;LINKS" ${ARGN})
  cmake_path(GET file STEM name)
  cmake_path(GET file PARENT_PATH folder)
  set(corpus ${CMAKE_CURRENT_SOURCE_DIR}/${folder}/testdata/${name})
  file(GLOB seeds ${corpus}/*)
  if(NOT seeds)
    message(FATAL_ERROR "${name}: no seed files in ${corpus}")
  endif()
  add_executable(${name} ${file} ${ARG_SOURCES})
  set_target_properties(${name} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/fuzz)
  target_link_libraries(${name} PRIVATE mapbed::flags ${ARG_LINKS})
  target_link_options(${name} PRIVATE -fsanitize=fuzzer)
  set_property(GLOBAL APPEND PROPERTY mapbed_fuzz_targets "${name}\;${corpus}")
endfunction()

# The tests of all fuzz targets; one after the other they take MAPBED_FUZZ_SECONDS. New inputs are
# kept under the build folder, those that fail in fuzz/failures-<name>-*.
function(mapbed_fuzz_tests)
  if(NOT MAPBED_FUZZ)
    return()
  endif()
  add_custom_target(mapbed_fuzz)
  get_property(targets GLOBAL PROPERTY mapbed_fuzz_targets)
  list(LENGTH targets count)
  if(count EQUAL 0)
    return()
  endif()
  math(EXPR seconds "${MAPBED_FUZZ_SECONDS} / ${count}")
  file(MAKE_DIRECTORY ${CMAKE_BINARY_DIR}/fuzz/files)
  foreach(target IN LISTS targets)
    list(GET target 0 name)
    list(GET target 1 seeds)
    add_dependencies(mapbed_fuzz ${name})
    file(MAKE_DIRECTORY ${CMAKE_BINARY_DIR}/fuzz/found-${name})
    add_test(NAME fuzz.${name} COMMAND ${name} -max_total_time=${seconds} -timeout=20
      -rss_limit_mb=2048 -max_len=16384 -print_final_stats=1
      -artifact_prefix=${CMAKE_BINARY_DIR}/fuzz/failures-${name}-
      ${CMAKE_BINARY_DIR}/fuzz/found-${name} ${seeds})
    set_tests_properties(fuzz.${name} PROPERTIES LABELS fuzz
      ENVIRONMENT "TMPDIR=${CMAKE_BINARY_DIR}/fuzz/files")
  endforeach()
endfunction()
