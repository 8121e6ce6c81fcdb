# enfilade_library(FOLDER USES folders... PUBLIC targets... PRIVATE targets...)
# One static library a folder, built of every .cpp in it, alias enfilade::FOLDER.
# USES names the folders that it may include from; PUBLIC and PRIVATE name outside libraries.
function(enfilade_compile_options target)
  target_compile_features(${target} PUBLIC cxx_std_20)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wconversion
    $<$<BOOL:${ENFILADE_WARNINGS_AS_ERRORS}>:-Werror>)
  # GCC 12 warns of std::string's own operator+ at -O3 (GCC bug 105651).
  target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>)
  # And of its copies, in precompiled headers that it no longer knows for the system's (GCC bug 105329).
  target_compile_options(${target} PRIVATE
    $<$<CXX_COMPILER_ID:GNU>:-Wno-stringop-overflow;-Wno-array-bounds>)
  # GCC 12's own std::stable_sort uses what its headers, read by another compiler, call deprecated.
  target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:Clang>:-Wno-deprecated-declarations>)
  # The same pixels on every build: no fused multiply-add where the source has none.
  target_compile_options(${target} PRIVATE -ffp-contract=off)
endfunction()

function(enfilade_library folder)
  cmake_parse_arguments(ARG "" "" "USES;PUBLIC;PRIVATE" ${ARGN})
  file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
  list(FILTER sources EXCLUDE REGEX "/main\\.cpp$")  # a program of its own
  if(NOT sources)
    file(WRITE ${CMAKE_CURRENT_BINARY_DIR}/empty.cpp "")
    set(sources ${CMAKE_CURRENT_BINARY_DIR}/empty.cpp)
  endif()
  add_library(enfilade_${folder} STATIC ${sources})
  add_library(enfilade::${folder} ALIAS enfilade_${folder})
  enfilade_compile_options(enfilade_${folder})
  target_include_directories(enfilade_${folder} PUBLIC ${PROJECT_SOURCE_DIR})
  # Halves the time of a first build; every file still includes what it uses.
  target_precompile_headers(enfilade_${folder} PRIVATE
    <algorithm> <array> <cmath> <functional> <map> <memory> <set> <string> <vector>
    <fmt/format.h> <glm/glm.hpp> <glm/gtc/quaternion.hpp>)
  list(TRANSFORM ARG_USES PREPEND enfilade::)
  target_link_libraries(enfilade_${folder} PUBLIC ${ARG_USES} ${ARG_PUBLIC} PRIVATE ${ARG_PRIVATE})
endfunction()

# enfilade_tests(FOLDER libraries...): tests/FOLDER/*_test.cpp as the program FOLDER_tests.
function(enfilade_tests folder)
  file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${folder}/*.cpp)
  if(ENFILADE_THREAD_TESTS)
    list(JOIN ENFILADE_THREADED "|" threaded)
    set(left_out ${sources})
    list(FILTER left_out INCLUDE REGEX "_test\\.cpp$")
    list(FILTER left_out EXCLUDE REGEX "/(${threaded})_test\\.cpp$")
    list(REMOVE_ITEM sources ${left_out} "")
  endif()
  set(tests ${sources})
  list(FILTER tests INCLUDE REGEX "_test\\.cpp$")
  if(NOT tests)
    return()
  endif()
  include(GoogleTest)
  add_executable(${folder}_tests ${sources})
  enfilade_compile_options(${folder}_tests)
  target_compile_options(${folder}_tests PRIVATE ${ENFILADE_TEST_OPTIONS})
  if(ENFILADE_TEST_OPTIONS)  # but not for what the tests share, which does the work
    list(FILTER sources EXCLUDE REGEX "_test\\.cpp$")
    set_source_files_properties(${sources} PROPERTIES
      COMPILE_OPTIONS "-O2" SKIP_PRECOMPILE_HEADERS ON)
  endif()
  target_link_libraries(${folder}_tests PRIVATE ${ARGN} GTest::gtest GTest::gtest_main)
  target_precompile_headers(${folder}_tests PRIVATE
    <gtest/gtest.h> <string> <vector> <glm/glm.hpp>)
  target_compile_definitions(${folder}_tests PRIVATE ENFILADE_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
  gtest_discover_tests(${folder}_tests DISCOVERY_MODE PRE_TEST PROPERTIES TIMEOUT 600)
endfunction()

# enfilade_embed(TARGET HEADER NAME FILE [NAME FILE ...]): the bytes of each FILE as the string_view
# enfilade::NAME, declared in HEADER; a FILE that was not found is empty.
function(enfilade_embed target header)
  set(pairs ${ARGN})
  set(script ${PROJECT_SOURCE_DIR}/cmake/EmbedFile.cmake)
  while(pairs)
    list(POP_FRONT pairs name file)
    if(NOT EXISTS "${file}")
      set(file "")
    endif()
    set(output ${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp)
    add_custom_command(OUTPUT ${output}
      COMMAND ${CMAKE_COMMAND} -DNAME=${name} -DINPUT=${file} -DHEADER=${header} -DOUTPUT=${output}
              -P ${script}
      DEPENDS ${script} ${file} VERBATIM)
    target_sources(${target} PRIVATE ${output})
  endwhile()
endfunction()
