// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/datasets/folder_export.h"

#include <algorithm>
#include <map>
#include <mutex>
#include <optional>
#include <vector>

#include <fmt/format.h>

#include "core/config/config_value.h"
#include "core/io/atomic_file.h"
#include "core/io/image_io.h"
#include "core/parallel/parallel_for.h"
#include "core/types/error.h"
#include "eval/datasets/dataset_config.h"
#include "eval/datasets/depth_image.h"
#include "eval/datasets/folder_layout.h"
#include "eval/datasets/ground_truth_io.h"
#include "eval/datasets/pose_file.h"
#include "eval/datasets/scan_export.h"

namespace hydrabench {
namespace fs = std::filesystem;
namespace layout = folder_layout;
namespace {

/// What is written once for all frames.
struct FrameRecord {
  StampedPose pose;
  std::map<InstanceId, Label> instance_labels;
  bool has_depth = true;
};

Image<std::uint16_t> narrowed(const Image<std::int32_t>& image, std::size_t frame,
                              const char* what) {
  Image<std::uint16_t> result(image.width(), image.height());
  for (std::size_t i = 0; i < image.size(); ++i) {
    const std::int32_t value = image.data()[i];
    if (value < 0 || value > 65535) {
      throw InputError(fmt::format("frame {}: {} {} does not fit the 16-bit images of the export",
                                   frame, what, value));
    }
    result.data()[i] = static_cast<std::uint16_t>(value);
  }
  return result;
}

/// Without a camera, sweeps are frames; the layout has no other frames then.
void requireOneScan(const Frame& frame, std::size_t index) {
  if (frame.scans.size() == 1 && frame.scans[0].stamp_ns == frame.stamp_ns) return;
  throw InputError(fmt::format(
      "frame {}: {} sweeps; without a camera, the export holds frames of one sweep each that ends "
      "with the frame",
      index, frame.scans.size()));
}

/// The quantum of the sensor, so that depth fits into 16-bit images; 0 where no candidate
/// reproduces it.
double findQuantum(const Image<float>& depth) {
  for (const double quantum_m : {1e-3, 1e-4, 2.5e-4, 2e-4, 5e-4}) {
    if (quantaFromDepth(depth, quantum_m)) return quantum_m;
  }
  return 0;
}

void writeDepth(const fs::path& folder, std::size_t index, double quantum_m,
                const Image<float>& depth) {
  const auto quanta =
      quantum_m > 0 ? quantaFromDepth(depth, quantum_m) : std::optional<Image<std::uint16_t>>();
  if (quanta) {
    writeGrayPng(folder / layout::image(layout::kDepth, index, ".png"), *quanta);
  } else {
    writeDepthPfm(folder / layout::image(layout::kDepth, index, ".pfm"), depth);
  }
}

FrameRecord writeFrame(const fs::path& folder, std::size_t index, double quantum_m,
                       const Frame& frame) {
  if (!frame.color.empty()) {
    writeColorPng(folder / layout::image(layout::kColor, index, ".png"), frame.color);
  }
  if (!frame.depth.empty()) writeDepth(folder, index, quantum_m, frame.depth);
  if (!frame.labels.empty()) {
    writeGrayPng(folder / layout::image(layout::kLabels, index, ".png"),
                 narrowed(frame.labels, index, "label"));
  }
  if (!frame.instances.empty()) {
    writeGrayPng(folder / layout::image(layout::kInstances, index, ".png"),
                 narrowed(frame.instances, index, "instance"));
  }
  return {{frame.stamp_ns, frame.T_world_camera},
          frame.instance_labels,
          frame.depth.empty() || hasDepth(frame.depth)};
}

void writeRecords(const fs::path& folder, const std::vector<FrameRecord>& records) {
  std::vector<StampedPose> poses;
  std::string labels = std::string(layout::kInstanceLabelsHeader) + "\n";
  for (std::size_t i = 0; i < records.size(); ++i) {
    poses.push_back(records[i].pose);
    for (const auto& [instance, label] : records[i].instance_labels) {
      labels += fmt::format("{},{},{}\n", i, instance, label);
    }
  }
  writePoses(folder / layout::kPoses, poses);
  writeFileAtomic(folder / layout::kInstanceLabels, labels);
}

bool hasCamera(const Dataset& dataset) { return dataset.camera().width > 0; }

std::string description(const Dataset& dataset, double quantum_m, bool require_depth,
                        const std::optional<LidarDescription>& lidar) {
  return fmt::format(
      "type: folder\nname: {}\nseed: {}\n{}{}depth_quantum_m: {}\nrequire_depth: {}\n{}",
      yamlText(dataset.name()), dataset.seed(),
      hasCamera(dataset) ? cameraYaml(dataset.camera()) : "", lidar ? lidarYaml(*lidar) : "",
      quantum_m > 0 ? quantum_m : 0.001, require_depth, labelSpaceYaml(dataset.labelSpace()));
}

}  // namespace

void exportDataset(const Dataset& dataset, const fs::path& path, const ExportOptions& options,
                   const std::function<void()>& advance) {
  const std::size_t num_frames = options.num_frames == 0
                                     ? dataset.numFrames()
                                     : std::min(options.num_frames, dataset.numFrames());
  if (num_frames == 0) throw InputError(fmt::format("{}: no frames to export", dataset.name()));
  AtomicFolder result(path, options.replace ? folder_layout::kDescription : "");
  const fs::path& folder = result.temporary();

  const double quantum_m = findQuantum(dataset.frame(0).depth);
  std::vector<FrameRecord> records(num_frames);
  std::mutex advancing;
  ScanExport scans(folder, num_frames);
  parallelFor(num_frames, [&](std::size_t i) {
    const Frame frame = dataset.frame(i);
    if (!hasCamera(dataset)) requireOneScan(frame, i);
    records[i] = writeFrame(folder, i, quantum_m, frame);
    scans.write(i, frame);
    if (!advance) return;
    const std::lock_guard lock(advancing);
    advance();
  });
  if (hasCamera(dataset)) writeRecords(folder, records);
  const std::optional<LidarDescription> lidar = scans.finish();
  if (dataset.hasGroundTruth()) {
    GroundTruth ground_truth = dataset.groundTruth();
    if (ground_truth.trajectory.size() > num_frames) ground_truth.trajectory.resize(num_frames);
    writeGroundTruth(folder / layout::kGroundTruth, ground_truth);
  }
  const bool all_have_depth =
      std::all_of(records.begin(), records.end(), [](const FrameRecord& r) { return r.has_depth; });
  writeFileAtomic(folder / layout::kDescription,
                  description(dataset, quantum_m, all_have_depth, lidar));
  result.commit();
}

}  // namespace hydrabench
