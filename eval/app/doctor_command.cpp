// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include <CLI/App.hpp>
#include <fmt/format.h>

#include "core/geometry/raycaster.h"
#include "core/parallel/parallel_for.h"
#include "core/shape/crisp/blas_kernel.h"
#include "core/shape/crisp/torch_runtime.h"
#include "eval/app/app.h"
#include "eval/experiment/provenance.h"
#include "eval/report/plot.h"

namespace hydrabench {
namespace {

bool commandSucceeds(const std::string& command) {
  return std::system((command + " >/dev/null 2>&1").c_str()) == 0;
}

/// One ray against one box: shows that the ray library works on this CPU (with the wrong ray mask
/// it silently hits nothing).
bool raysHit() {
  Raycaster raycaster;
  raycaster.add(boxMesh(Aabb(Eigen::Vector3d(-1, -1, 1), Eigen::Vector3d(1, 1, 2))));
  raycaster.commit();
  const Raycaster::Hit hit =
      raycaster.intersect({Eigen::Vector3f(0.1f, 0.2f, 0), Eigen::Vector3f::UnitZ()});
  return hit && std::abs(hit.distance - 1.0f) < 1e-6f;
}

std::string listOf(const CpuFeatures& cpu) {
  std::string list;
  const auto add = [&](bool there, const char* name) {
    if (there) list += (list.empty() ? "" : ", ") + std::string(name);
  };
  add(cpu.avx2, "AVX2");
  add(cpu.avx512, "AVX-512");
  add(cpu.bf16, "bf16");
  add(cpu.amx, "AMX");
  return list.empty() ? "none of AVX2, AVX-512, bf16, AMX" : list;
}

/// What the learned shapes compute with: libtorch, and the BLAS below it, which decides their
/// speed.
void reportMatrixProducts(const std::function<void(const std::string&, const std::string&)>& line) {
  line("libtorch", torchVersion() + (torchSeesCuda() ? ", with a GPU" : ", without GPU"));
  const CpuFeatures cpu = cpuFeatures();
  line("vector units", listOf(cpu));
  const std::string kernel = blasKernel();
  const double rate = matrixProductRate(0.5);
  line("matrix products",
       fmt::format("{}, {:.0f} GFLOP/s on one thread",
                   kernel.empty() ? "not OpenBLAS" : "OpenBLAS, kernel " + kernel, rate));
  const std::string faster = fastestKernel(cpu);
  if (isSlowKernel(kernel, cpu)) {
    line("", fmt::format("WARNING: a slow fallback for this processor; set OPENBLAS_CORETYPE={}",
                         faster));
  } else if (kernel.empty() && !faster.empty()) {
    line("", "WARNING: most likely slow; install libopenblas0-openmp (scripts/setup does)");
  }
}

int doctor() {
  const Provenance provenance = currentProvenance(commandLine());
  bool healthy = true;
  const auto line = [](const std::string& what, const std::string& finding) {
    fmt::print("  {:<18} {}\n", what, finding);
  };
  const auto check = [&](const std::string& what, bool good, const std::string& finding) {
    healthy = healthy && good;
    line(what, (good ? "ok: " : "FAULT: ") + finding);
  };
  fmt::print("hydrabench {}\n", versionLine(provenance));
  line("system", provenance.system);
  line("processor", fmt::format("{}, {} cores, {} threads in use", provenance.cpu, provenance.cores,
                                numThreads()));
  std::error_code error;
  const auto space = std::filesystem::space(std::filesystem::temp_directory_path(error), error);
  check("temporary folder", !error && space.available > (std::uintmax_t{1} << 30),
        error ? error.message()
              : fmt::format("{:.1f} GiB free", static_cast<double>(space.available) / (1 << 30)));
  check("ray casting", raysHit(), "Embree");
  reportMatrixProducts(line);

  // What is missing below costs a comparison or a dataset, not the tool.
  line("plots", canPlot() ? "gnuplot"
                          : "missing: scripts are written but not drawn; install gnuplot-nox "
                            "(scripts/setup does)");
  const char* data = std::getenv("HYDRABENCH_DATA");
  line("third-party data", data && std::filesystem::is_directory(data)
                               ? data
                               : "none: set HYDRABENCH_DATA to its folder for the servicesim, "
                                 "7-Scenes and APC datasets");
  for (const char* module : {"scipy", "open3d", "torch"}) {
    line(fmt::format("python3-{}", module),
         commandSucceeds(fmt::format("/usr/bin/python3 -c 'import {}'", module))
             ? "there: tests compare against it"
             : "missing: tests that compare against it are skipped (scripts/setup --oracles)");
  }
  fmt::print("{}\n",
             healthy ? "all that is needed works" : "something that is needed does not work");
  return healthy ? kDone : kGateFailed;
}

}  // namespace

Command addDoctor(CLI::App&) {
  return [] { return doctor(); };
}

}  // namespace hydrabench
