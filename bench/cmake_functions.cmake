# The build's own functions: packages, warnings, libraries with their tests.

# find_package with the Debian package in the error message.
macro(mapbed_package name debian_package)
  find_package(${name} ${ARGN} QUIET)
  if(NOT ${name}_FOUND)
    message(FATAL_ERROR "${name} not found; install it with: apt-get install ${debian_package}")
  endif()
endmacro()

add_library(mapbed_flags INTERFACE)
# Contraction off and no -march=native: results must not depend on the processor.
target_compile_options(mapbed_flags INTERFACE
  -Wall -Wextra -Wconversion -Wshadow -Wno-restrict -ffp-contract=off  # g++ 12 sees -Wrestrict in std::string
  $<$<BOOL:${MAPBED_WERROR}>:-Werror>)
add_library(mapbed::flags ALIAS mapbed_flags)
install(TARGETS mapbed_flags EXPORT mapbed)

# One precompiled header for all tests: GoogleTest and Eigen cost most of a test file's compile time.
if(MAPBED_TESTS)
  file(WRITE ${CMAKE_BINARY_DIR}/test_pch.cpp "")
  add_library(mapbed_test_pch STATIC ${CMAKE_BINARY_DIR}/test_pch.cpp)
  target_link_libraries(mapbed_test_pch PUBLIC mapbed::flags GTest::gtest GTest::gmock Eigen3::Eigen)
  target_precompile_headers(mapbed_test_pch PRIVATE <gmock/gmock.h> <gtest/gtest.h> <Eigen/Dense>)
endif()

# mapbed_library(core SOURCES a.cpp … TESTS a_test.cpp … TEST_LINKS … PUBLIC_LINKS … PRIVATE_LINKS …)
# makes mapbed_core (alias mapbed::core) and, where tests are built, mapbed_core_tests.
function(mapbed_library name)
  cmake_parse_arguments(ARG "" "" "SOURCES;TESTS;TEST_LINKS;PUBLIC_LINKS;PRIVATE_LINKS" ${ARGN})
  add_library(mapbed_${name} STATIC ${ARG_SOURCES})
  add_library(mapbed::${name} ALIAS mapbed_${name})
  set_target_properties(mapbed_${name} PROPERTIES EXPORT_NAME ${name} POSITION_INDEPENDENT_CODE ON)
  target_compile_features(mapbed_${name} PUBLIC cxx_std_20)
  target_include_directories(mapbed_${name} PUBLIC
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/mapbed>)
  target_link_libraries(mapbed_${name} PUBLIC ${ARG_PUBLIC_LINKS} PRIVATE mapbed::flags ${ARG_PRIVATE_LINKS})
  if(MAPBED_TESTS AND ARG_TESTS)
    add_executable(mapbed_${name}_tests ${ARG_TESTS})
    target_precompile_headers(mapbed_${name}_tests REUSE_FROM mapbed_test_pch)
    target_link_libraries(mapbed_${name}_tests PRIVATE
      mapbed::${name} mapbed::flags GTest::gtest GTest::gmock GTest::gmock_main ${ARG_TEST_LINKS})
    target_compile_definitions(mapbed_${name}_tests PRIVATE MAPBED_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
    include(GoogleTest)
    gtest_discover_tests(mapbed_${name}_tests DISCOVERY_MODE PRE_TEST PROPERTIES LABELS unit)
  endif()
endfunction()
