# SPDX-FileCopyrightText: 2026 The hydrabench authors
# SPDX-License-Identifier: MIT
#
# Includes name a file from the repository root ("core/geometry/mesh.h"), yet a library must not reach every folder: ground truth
# (eval/) may never enter a method (core/, baselines/). So each layer gets an include root of its own, made of links to just the
# folders it may see. `hydrabench_library(NAME LAYER ...)` is the one way to add a library.

function(hydrabench_include_root layer)
  set(root ${PROJECT_BINARY_DIR}/include_roots/${layer})
  foreach(folder IN LISTS ARGN)
    get_filename_component(parent ${root}/${folder} DIRECTORY)
    file(MAKE_DIRECTORY ${parent})
    file(CREATE_LINK ${PROJECT_SOURCE_DIR}/${folder} ${root}/${folder} SYMBOLIC)
  endforeach()
endfunction()

hydrabench_include_root(core core)
hydrabench_include_root(metrics metrics core/types core/geometry)
hydrabench_include_root(baselines baselines core)
hydrabench_include_root(eval eval baselines metrics core)
hydrabench_include_root(tests tests eval baselines metrics core)

# Flags of our own targets: warnings are errors, no fused multiply-add (it would make results depend on the compiler's choice of
# instructions), sanitizers on request.
add_library(hydrabench_flags INTERFACE)
target_compile_options(hydrabench_flags INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Woverloaded-virtual -Werror -ffp-contract=off
  -Wno-restrict)  # false alarms on std::string concatenation in GCC 12 (GCC bug 105651)
if(NOT CMAKE_BUILD_TYPE STREQUAL Debug AND NOT HYDRABENCH_SANITIZE)
  # GCC 12 at -O2 and above drops the rounding in double -> float -> double over straight-line code, so a value rounded for a file would
  # differ from the one in memory.
  target_compile_options(hydrabench_flags INTERFACE -fno-tree-slp-vectorize)
endif()
if(CMAKE_BUILD_TYPE STREQUAL Debug)
  target_compile_definitions(hydrabench_flags INTERFACE _GLIBCXX_ASSERTIONS)
  target_compile_options(hydrabench_flags INTERFACE -Wno-maybe-uninitialized)  # false alarms at -Og inside CGAL and libstdc++
endif()
if(HYDRABENCH_SANITIZE)
  # Eigen and libstdc++ trip GCC's flow-based warnings only under instrumentation.
  target_compile_options(hydrabench_flags INTERFACE
    -fsanitize=${HYDRABENCH_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all
    -Wno-maybe-uninitialized -Wno-array-bounds -Wno-stringop-overflow -Wno-tsan)
  target_link_options(hydrabench_flags INTERFACE -fsanitize=${HYDRABENCH_SANITIZE})
endif()

# hydrabench_library(NAME LAYER <layer> SOURCES ... [PUBLIC targets...] [PRIVATE targets...])
function(hydrabench_library name)
  cmake_parse_arguments(ARG "" "LAYER" "SOURCES;PUBLIC;PRIVATE" ${ARGN})
  add_library(${name} STATIC ${ARG_SOURCES})
  target_include_directories(${name} PRIVATE ${PROJECT_BINARY_DIR}/include_roots/${ARG_LAYER})
  target_link_libraries(${name} PUBLIC Eigen3::Eigen ${ARG_PUBLIC} PRIVATE hydrabench_flags fmt::fmt ${ARG_PRIVATE})
endfunction()
