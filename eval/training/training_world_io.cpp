// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstring>
#include <string>

#include "core/io/atomic_file.h"
#include "core/shape/latent_flow/latent_grid.h"
#include "eval/training/training_world.h"

namespace hydrabench {
namespace {

constexpr float kPointStep_m = 0.001f;
constexpr float kUnitStep = 2.0f / 32767;  // object coordinates and distances lie within +-2

/// Identifies format and config.
std::string header(const TrainingWorldConfig& config) {
  return "hydrabench training world 1 " + std::to_string(config.frames) + " " +
         std::to_string(config.max_views_per_shape) + " " + std::to_string(config.sdf_points) +
         " " + std::to_string(config.min_pixels) + " " + std::to_string(config.image_width) + " " +
         std::to_string(config.clean_masks) + " " + std::to_string(config.max_depth_m) +
         (config.world == "office" ? "" : " " + config.world) +
         (config.objects == "scored" ? "" : " " + config.objects) +
         (config.grid_frames == 0 ? "" : " " + std::to_string(config.grid_frames)) + "\n";
}

class Writer {
 public:
  template <typename Value>
  void add(const Value& value) {
    static_assert(std::is_trivially_copyable_v<Value>);
    bytes.append(reinterpret_cast<const char*>(&value), sizeof(Value));
  }
  void add(const std::string& text) {
    add(static_cast<std::uint32_t>(text.size()));
    bytes += text;
  }
  void add(const ShapeGrid& grid) {
    for (int axis = 0; axis < 3; ++axis) add(grid.frame.center[axis]);
    add(grid.frame.bearing);
    add(grid.frame.scale);
    bytes.append(reinterpret_cast<const char*>(grid.values.data()), grid.values.size());
  }
  void addRounded(float value, float step) {
    add(static_cast<std::int16_t>(std::lround(value / step)));
  }
  void add(const std::vector<Eigen::Vector3f>& points, float step) {
    add(static_cast<std::uint32_t>(points.size()));
    for (const Eigen::Vector3f& p : points) {
      for (int axis = 0; axis < 3; ++axis) addRounded(p[axis], step);
    }
  }
  std::string bytes;
};

class Reader {
 public:
  explicit Reader(const std::string& bytes, std::size_t at) : bytes_(bytes), at_(at) {}
  template <typename Value>
  Value get() {
    Value value{};
    if (at_ + sizeof(Value) <= bytes_.size()) {
      std::memcpy(&value, bytes_.data() + at_, sizeof(Value));
    }
    at_ += sizeof(Value);
    return value;
  }
  std::string text() {
    const auto size = get<std::uint32_t>();
    std::string result = at_ + size <= bytes_.size() ? bytes_.substr(at_, size) : "";
    at_ += size;
    return result;
  }
  float rounded(float step) { return step * static_cast<float>(get<std::int16_t>()); }
  std::size_t count(std::size_t item_bytes) {  // never more than there are bytes for
    const auto size = get<std::uint32_t>();
    return at_ + size * item_bytes <= bytes_.size() ? size : 0;
  }
  std::vector<Eigen::Vector3f> points(float step) {
    std::vector<Eigen::Vector3f> result(count(3 * sizeof(std::int16_t)));
    for (Eigen::Vector3f& p : result) {
      for (int axis = 0; axis < 3; ++axis) p[axis] = rounded(step);
    }
    return result;
  }
  ShapeGrid grid() {
    ShapeGrid result;
    for (int axis = 0; axis < 3; ++axis) result.frame.center[axis] = get<double>();
    result.frame.bearing = get<double>();
    result.frame.scale = get<double>();
    result.values.resize(kGridSide * kGridSide * kGridSide);
    if (at_ + result.values.size() <= bytes_.size()) {
      std::memcpy(result.values.data(), bytes_.data() + at_, result.values.size());
    }
    at_ += result.values.size();
    return result;
  }
  bool complete() const { return at_ == bytes_.size(); }

 private:
  const std::string& bytes_;
  std::size_t at_;
};

}  // namespace

void writeTrainingWorld(const std::filesystem::path& path, const TrainingWorldConfig& config,
                        const TrainingWorld& world) {
  Writer writer;
  writer.bytes = header(config);
  writer.add(static_cast<std::uint32_t>(world.shapes.size()));
  for (const TrainingShape& shape : world.shapes) {
    writer.add(shape.family);
    writer.add(shape.class_name);
    writer.add(shape.yaw_symmetry);
    writer.add(shape.half_extent_m);
    writer.add(shape.points, kUnitStep);
    for (const float distance : shape.distances) writer.addRounded(distance, kUnitStep);
    for (const ShapeGrid& grid : shape.grids) writer.add(grid);
  }
  writer.add(static_cast<std::uint32_t>(world.views.size()));
  for (const TrainingView& view : world.views) {
    writer.add(view.shape);
    for (int axis = 0; axis < 3; ++axis) writer.add(view.center[axis]);
    writer.add(view.yaw);
    writer.add(static_cast<std::uint8_t>(view.clean));
    for (const float cut : view.points.cut) writer.add(static_cast<std::uint8_t>(cut));
    writer.add(view.points.object, kPointStep_m);
    for (const std::uint8_t on : view.on_object) writer.add(on);
    writer.add(view.points.context, kPointStep_m);
  }
  std::filesystem::create_directories(path.parent_path());
  writeFileAtomic(path, writer.bytes);
}

std::optional<TrainingWorld> readTrainingWorld(const std::filesystem::path& path,
                                               const TrainingWorldConfig& config) {
  if (!std::filesystem::exists(path)) return std::nullopt;
  const std::string bytes = readFile(path);
  const std::string expected = header(config);
  if (bytes.compare(0, expected.size(), expected) != 0) return std::nullopt;
  Reader reader(bytes, expected.size());
  TrainingWorld world;
  world.shapes.resize(reader.count(1));
  for (TrainingShape& shape : world.shapes) {
    shape.family = reader.text();
    shape.class_name = reader.text();
    shape.yaw_symmetry = reader.get<int>();
    shape.half_extent_m = reader.get<float>();
    shape.points = reader.points(kUnitStep);
    shape.distances.resize(shape.points.size());
    for (float& distance : shape.distances) distance = reader.rounded(kUnitStep);
    for (int i = 0; i < config.grid_frames; ++i) shape.grids.push_back(reader.grid());
  }
  world.views.resize(reader.count(1));
  for (TrainingView& view : world.views) {
    view.shape = reader.get<std::uint32_t>();
    for (int axis = 0; axis < 3; ++axis) view.center[axis] = reader.get<float>();
    view.yaw = reader.get<float>();
    view.clean = reader.get<std::uint8_t>() != 0;
    for (float& cut : view.points.cut) cut = reader.get<std::uint8_t>();
    view.points.object = reader.points(kPointStep_m);
    view.on_object.resize(view.points.object.size());
    for (std::uint8_t& on : view.on_object) on = reader.get<std::uint8_t>();
    view.points.context = reader.points(kPointStep_m);
    if (view.shape >= world.shapes.size()) return std::nullopt;
  }
  if (!reader.complete()) return std::nullopt;
  return world;
}

}  // namespace hydrabench
