# SPDX-FileCopyrightText: 2026 The hydrabench authors
# SPDX-License-Identifier: MIT
#
# Every package from outside, all of them Debian's. Each heavy one is linked PRIVATE by the one library that wraps it.
find_package(Threads REQUIRED)
find_package(PkgConfig REQUIRED)
find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(fmt REQUIRED CONFIG)
find_package(yaml-cpp REQUIRED CONFIG)
find_package(nlohmann_json REQUIRED CONFIG)
find_package(CLI11 REQUIRED CONFIG)
find_package(TBB REQUIRED)
find_package(CGAL 5.5 REQUIRED QUIET)
include(CGAL_Eigen3_support)
find_package(OpenMesh REQUIRED CONFIG)
find_package(meshoptimizer REQUIRED CONFIG)
find_package(flann REQUIRED CONFIG)
# FLANN's headers call LZ4, which its own CMake target forgets.
pkg_check_modules(LZ4 REQUIRED IMPORTED_TARGET liblz4)
# Debian 12 has Embree 3; newer systems have Embree 4. core/geometry/raycaster.cpp speaks both.
find_package(embree 4 CONFIG QUIET)
if(NOT embree_FOUND)
  find_package(embree 3 REQUIRED CONFIG)
endif()
find_package(PNG REQUIRED)
find_package(ZLIB REQUIRED)
find_package(JPEG REQUIRED)
find_package(OpenSSL REQUIRED COMPONENTS Crypto)
find_package(GTest REQUIRED)
find_package(benchmark REQUIRED CONFIG)
# Any libtorch: Debian's, or one that Torch_DIR or CMAKE_PREFIX_PATH points at (CUDA included).
find_package(Torch REQUIRED QUIET)
add_library(hydrabench_torch INTERFACE)
target_link_libraries(hydrabench_torch INTERFACE ${TORCH_LIBRARIES})
