# One call per folder: every .cpp beside the CMakeLists.txt, or in internal/, belongs to its library, every .cpp in
# tests/ to its test program.

include(GNUInstallDirs)

add_library(isopatch_settings INTERFACE)
target_compile_features(isopatch_settings INTERFACE cxx_std_20)
target_include_directories(isopatch_settings INTERFACE
  $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>
  $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/isopatch>)
# Eigen aligns its objects by the instruction set, so users must compile with the same one.
if(ISOPATCH_NATIVE)
  target_compile_options(isopatch_settings INTERFACE -march=native)
endif()
# Threads are ours to give: Eigen's own would spin in every small product.
target_compile_definitions(isopatch_settings INTERFACE EIGEN_DONT_PARALLELIZE)
set_target_properties(isopatch_settings PROPERTIES EXPORT_NAME settings)
# GCC 12 reports its own AVX-512 intrinsics as uninitialized and its own string concatenation as overlapping
# (bug 105651), so those warnings stay off.
set(ISOPATCH_WARNINGS -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor)
if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
  list(APPEND ISOPATCH_WARNINGS -Wno-maybe-uninitialized -Wno-restrict)
endif()

# A compiler that lives some seconds gains nothing from collecting its garbage (4 to 17 % of its time, a tenth more memory).
set(ISOPATCH_COMPILER_MEMORY)
if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
  set(ISOPATCH_COMPILER_MEMORY --param=ggc-min-heapsize=4194304)
endif()

# Reading headers takes more of a build than our own code. So what most sources include is read once for all targets
# that are compiled alike: GCC takes such headers only where optimisation, OpenMP, definitions, -Wpedantic and position
# independence agree, and warns where they do not.
set(ISOPATCH_COMMON_HEADERS <Eigen/Core> <Eigen/Geometry> <Eigen/LU> <fmt/format.h> <fmt/ranges.h> <algorithm> <array>
  <cmath> <filesystem> <functional> <map> <memory> <optional> <string> <string_view> <vector>)

# Makes isopatch_headers_KIND, for the kinds full, light and tests.
function(isopatch_common_headers kind)
  set(owner isopatch_headers_${kind})
  file(WRITE "${PROJECT_BINARY_DIR}/headers/${kind}.cpp" "")
  add_library(${owner} OBJECT "${PROJECT_BINARY_DIR}/headers/${kind}.cpp")
  target_link_libraries(${owner} PRIVATE isopatch_settings Eigen3::Eigen fmt::fmt OpenMP::OpenMP_CXX)
  target_compile_options(${owner} PRIVATE ${ISOPATCH_WARNINGS} ${ISOPATCH_COMPILER_MEMORY})
  target_precompile_headers(${owner} PRIVATE ${ISOPATCH_COMMON_HEADERS})
  if(kind STREQUAL tests)
    target_link_libraries(${owner} PRIVATE GTest::gtest GTest::gmock)
    target_precompile_headers(${owner} PRIVATE <gmock/gmock.h> <gtest/gtest.h>)
  else()
    set_target_properties(${owner} PROPERTIES POSITION_INDEPENDENT_CODE ON)
  endif()
  isopatch_optimise(${owner} ${kind})
endfunction()

# Light targets compute nothing that takes long, so a release compiles them lightly, which saves a third of the time;
# tests spend theirs in the libraries.
function(isopatch_optimise target kind)
  if(kind STREQUAL tests)
    target_compile_options(${target} PRIVATE -O1)
  elseif(kind STREQUAL light)
    target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
  endif()
endfunction()

# isopatch_compile(TARGET KIND): with our warnings, as its kind is compiled; several sources as one, which halves the
# time. So names in unnamed namespaces must differ within a folder. Some warnings make no sense then, and those about
# AVX-512 are more.
function(isopatch_compile target kind)
  target_compile_options(${target} PRIVATE ${ISOPATCH_WARNINGS} ${ISOPATCH_COMPILER_MEMORY})
  isopatch_optimise(${target} ${kind})
  if(NOT ISOPATCH_UNITY)
    return()
  endif()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 16)
  target_compile_options(${target} PRIVATE -Wno-shadow)
  if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
    target_compile_options(${target} PRIVATE -Wno-subobject-linkage -Wno-uninitialized -Wno-array-bounds
      -Wno-stringop-overread -Wno-stringop-overflow)
  endif()
  if(NOT TARGET isopatch_headers_${kind})
    isopatch_common_headers(${kind})
  endif()
  target_link_libraries(${target} PRIVATE fmt::fmt OpenMP::OpenMP_CXX)
  target_precompile_headers(${target} REUSE_FROM isopatch_headers_${kind})
endfunction()

# isopatch_library(NAME [LIGHT] [ROOMS folders...] [PUBLIC targets...] [PRIVATE targets...]): target isopatch_NAME, alias
# isopatch::NAME. ROOMS are subfolders that belong to it. LIGHT ones are compiled lightly.
function(isopatch_library name)
  cmake_parse_arguments(arg "LIGHT" "" "ROOMS;PUBLIC;PRIVATE" ${ARGN})
  set(patterns)
  foreach(folder . ${arg_ROOMS})
    list(APPEND patterns "${CMAKE_CURRENT_SOURCE_DIR}/${folder}/*.cpp" "${CMAKE_CURRENT_SOURCE_DIR}/${folder}/internal/*.cpp")
  endforeach()
  file(GLOB sources CONFIGURE_DEPENDS ${patterns})
  add_library(isopatch_${name} STATIC ${sources})
  add_library(isopatch::${name} ALIAS isopatch_${name})
  set_target_properties(isopatch_${name} PROPERTIES EXPORT_NAME ${name} POSITION_INDEPENDENT_CODE ON)
  target_link_libraries(isopatch_${name} PUBLIC isopatch_settings ${arg_PUBLIC} PRIVATE ${arg_PRIVATE})
  if(arg_LIGHT)
    isopatch_compile(isopatch_${name} light)
  else()
    isopatch_compile(isopatch_${name} full)
  endif()
  set_property(GLOBAL APPEND PROPERTY ISOPATCH_LIBRARIES isopatch_${name})
endfunction()

set(ISOPATCH_TEST_ENVIRONMENT OPENBLAS_NUM_THREADS=1 OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1)

# isopatch_tests(NAME targets... [LABELS labels...]): program test_NAME from tests/*.cpp, one CTest
# entry for each TEST.
function(isopatch_tests name)
  if(NOT ISOPATCH_TESTS)
    return()
  endif()
  cmake_parse_arguments(arg "" "" "LABELS" ${ARGN})
  file(GLOB sources CONFIGURE_DEPENDS "${CMAKE_CURRENT_SOURCE_DIR}/tests/*.cpp")
  if(NOT sources)
    return()
  endif()
  add_executable(test_${name} ${sources})
  target_link_libraries(test_${name} PRIVATE ${arg_UNPARSED_ARGUMENTS} GTest::gtest GTest::gmock GTest::gtest_main)
  # Nothing links the program that reads CAD files, but what reads them starts it.
  if(TARGET isopatch_cad_reader)
    add_dependencies(test_${name} isopatch_cad_reader)
  endif()
  isopatch_compile(test_${name} tests)
  target_link_libraries(test_${name} PRIVATE isopatch_startup)
  target_compile_definitions(test_${name} PRIVATE ISOPATCH_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
  if(NOT arg_LABELS)
    set(arg_LABELS quick)
  endif()
  gtest_discover_tests(test_${name} TEST_PREFIX "${name}." DISCOVERY_TIMEOUT 60
    PROPERTIES LABELS "${arg_LABELS}" ENVIRONMENT "${ISOPATCH_TEST_ENVIRONMENT}")
endfunction()

# isopatch_process_tests(NAME COUNTS counts... COMMAND command...): CTest entries NAME.COUNT that start the command
# as COUNT processes.
function(isopatch_process_tests name)
  cmake_parse_arguments(arg "" "" "COUNTS;COMMAND" ${ARGN})
  foreach(count ${arg_COUNTS})
    add_test(NAME ${name}.${count} COMMAND
      ${MPIEXEC_EXECUTABLE} --oversubscribe ${MPIEXEC_NUMPROC_FLAG} ${count} ${arg_COMMAND})
    set_tests_properties(${name}.${count} PROPERTIES LABELS quick TIMEOUT 120 PROCESSORS ${count}
      ENVIRONMENT "${ISOPATCH_TEST_ENVIRONMENT}")
  endforeach()
endfunction()

# isopatch_parallel_tests(NAME targets...): program test_NAME_parallel from tests/parallel/*.cpp, started as 1, 2 and 3
# processes.
function(isopatch_parallel_tests name)
  if(NOT ISOPATCH_TESTS)
    return()
  endif()
  file(GLOB sources CONFIGURE_DEPENDS "${CMAKE_CURRENT_SOURCE_DIR}/tests/parallel/*.cpp")
  add_executable(test_${name}_parallel ${sources})
  target_link_libraries(test_${name}_parallel PRIVATE ${ARGN} GTest::gtest GTest::gmock GTest::gtest_main)
  isopatch_compile(test_${name}_parallel tests)
  target_link_libraries(test_${name}_parallel PRIVATE isopatch_startup)
  isopatch_process_tests(${name}.parallel COUNTS 1 2 3 COMMAND test_${name}_parallel --gtest_brief=1)
endfunction()
