// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/datasets/open_dataset.h"

#include <cstdlib>
#include <optional>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/types/error.h"
#include "tests/support/temporary_folder.h"

namespace hydrabench {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

/// Sets or clears an environment variable for one test.
class ScopedVariable {
 public:
  ScopedVariable(const char* name, const char* value) : name_(name) {
    if (const char* before = std::getenv(name)) before_ = before;
    value ? ::setenv(name, value, 1) : ::unsetenv(name);
  }
  ~ScopedVariable() { before_ ? ::setenv(name_, before_->c_str(), 1) : ::unsetenv(name_); }
  ScopedVariable(const ScopedVariable&) = delete;
  ScopedVariable& operator=(const ScopedVariable&) = delete;

 private:
  const char* name_;
  std::optional<std::string> before_;
};

std::string faultOf(const std::string& yaml) {
  TemporaryFolder folder;
  writeText(folder / "d.yaml", yaml);
  std::string message = messageOf<InputError>([&] { openDataset(folder / "d.yaml"); });
  const std::string prefix = folder.path().string() + "/";
  for (std::size_t at; (at = message.find(prefix)) != std::string::npos;) {
    message.erase(at, prefix.size());
  }
  return message;
}

TEST(OpenDataset, AMissingTypeListsAllTypes) {
  EXPECT_EQ(
      faultOf("seed: 3\n"),
      "d.yaml: type: missing, expected one of: simulated, folder, placed_meshes, mesh_gallery, "
      "seven_scenes, apc2016, kitti_raw");
}

TEST(OpenDataset, AnUnknownTypeSuggestsOne) {
  EXPECT_EQ(
      faultOf("type: simulatd\nseed: 3\n"),
      "d.yaml:1: type: 'simulatd' is unknown, expected one of: simulated, folder, "
      "placed_meshes, mesh_gallery, seven_scenes, apc2016, kitti_raw; did you mean simulated?");
}

TEST(OpenDataset, KeysOfOtherTypesAreUnknown) {
  EXPECT_THAT(faultOf("type: simulated\ndepth_quantum_m: 1\n"),
              HasSubstr("d.yaml:2: depth_quantum_m: unknown key"));
}

TEST(OpenDataset, AMissingDataRootSaysBothWaysToGiveIt) {
  const ScopedVariable unset("HYDRABENCH_DATA", nullptr);
  EXPECT_EQ(faultOf("type: apc2016\n"),
            "d.yaml: root: no folder of data sets: give --data, the key root, or the environment "
            "variable HYDRABENCH_DATA");
}

TEST(OpenDataset, ADataRootThatDoesNotExistIsNamed) {
  EXPECT_EQ(faultOf("type: apc2016\nroot: /nowhere/data\n"),
            "d.yaml:2: root: no such folder: /nowhere/data");
  const ScopedVariable wrong("HYDRABENCH_DATA", "/nowhere/else");
  EXPECT_THAT(faultOf("type: apc2016\n"),
              HasSubstr("root: no such folder: /nowhere/else (from --data or the environment "
                        "variable HYDRABENCH_DATA)"));
}

TEST(OpenDataset, AFolderThatIsNotThereIsOneLine) {
  TemporaryFolder data;
  const ScopedVariable variable("HYDRABENCH_DATA", data.path().c_str());
  EXPECT_EQ(faultOf("type: apc2016\nfolder: shelf\n"), "d.yaml:2: folder: no such folder: shelf");
}

}  // namespace
}  // namespace hydrabench
