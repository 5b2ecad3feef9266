// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/oracles/oracle_frames.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <utility>

#include "core/types/random.h"

namespace hydrabench {
namespace {

constexpr std::uint64_t kIdSeed = 20265;

/// 1 .. count in an order that says nothing about the objects.
std::vector<InstanceId> shuffledIds(std::size_t count, std::uint64_t seed) {
  std::vector<InstanceId> ids(count);
  std::iota(ids.begin(), ids.end(), 1);
  Random random(seed);
  for (std::size_t i = count; i > 1; --i) {
    std::swap(ids[i - 1], ids[random.index(static_cast<std::uint32_t>(i))]);
  }
  return ids;
}

}  // namespace

OracleFrames::OracleFrames(std::unique_ptr<MappingSystem> system,
                           std::shared_ptr<const TrueInstances> truth, const Mends& mends)
    : system_(std::move(system)),
      truth_(std::move(truth)),
      mends_(mends),
      next_stray_id_(static_cast<InstanceId>(truth_->objects().size()) + 1) {}

std::vector<std::string> OracleFrames::notes() const {
  std::vector<std::string> notes = system_->notes();
  if (mends_.masks) notes.push_back("told the true masks");
  if (mends_.association) notes.push_back("told which masks show the same object");
  return notes;
}

Frame OracleFrames::mended(const Frame& frame) {
  Frame result = frame;
  if (mends_.masks) giveTrueMasks(result);
  if (mends_.association) givePersistentIds(result);
  return result;
}

void OracleFrames::giveTrueMasks(Frame& frame) const {
  const Image<std::int32_t> seen =
      truth_->render(frame.camera, truth_->cameraPose(frame.stamp_ns, frame.T_world_camera));
  std::map<std::int32_t, InstanceId> id_of;
  for (const std::int32_t object : seen) {
    if (object != TrueInstances::kNoObject) id_of.emplace(object, kNoInstance);
  }
  const auto ids =
      shuffledIds(id_of.size(), hashSeed(kIdSeed, static_cast<std::uint64_t>(frame.stamp_ns)));
  std::set<Label> object_labels;
  frame.instance_labels.clear();
  std::size_t next = 0;
  for (auto& [object, id] : id_of) {
    id = ids[next++];
    frame.instance_labels[id] = truth_->objects()[static_cast<std::size_t>(object)].label;
  }
  for (const GroundTruthObject& object : truth_->objects()) object_labels.insert(object.label);

  frame.instances = Image<InstanceId>(seen.width(), seen.height());
  for (std::size_t i = 0; i < seen.size(); ++i) {
    const std::int32_t object = seen.data()[i];
    if (object != TrueInstances::kNoObject) frame.instances.data()[i] = id_of.at(object);
    if (frame.labels.empty()) continue;
    Label& label = frame.labels.data()[i];
    if (object != TrueInstances::kNoObject) {
      label = truth_->objects()[static_cast<std::size_t>(object)].label;
    } else if (object_labels.contains(label)) {
      label = kUnknownLabel;  // a mask that went beyond its object; the class behind is not known
    }
  }
}

void OracleFrames::givePersistentIds(Frame& frame) {
  std::map<InstanceId, std::vector<std::uint32_t>> pixels_of;
  for (std::size_t i = 0; i < frame.instances.size(); ++i) {
    const InstanceId id = frame.instances.data()[i];
    if (id != kNoInstance) pixels_of[id].push_back(static_cast<std::uint32_t>(i));
  }
  const Transform T_world_camera = truth_->cameraPose(frame.stamp_ns, frame.T_world_camera);
  std::map<InstanceId, Label> labels;
  std::map<InstanceId, std::size_t> largest;  // piece of each new id
  for (const auto& [id, pixels] : pixels_of) {
    const auto object = truth_->mostSeen(frame.camera, T_world_camera, pixels);
    const InstanceId renamed = object ? static_cast<InstanceId>(*object) + 1 : next_stray_id_++;
    for (const std::uint32_t pixel : pixels) frame.instances.data()[pixel] = renamed;
    const auto label = frame.instance_labels.find(id);
    if (label == frame.instance_labels.end() || pixels.size() <= largest[renamed]) continue;
    largest[renamed] = pixels.size();
    labels[renamed] = label->second;
  }
  frame.instance_labels = std::move(labels);
}

}  // namespace hydrabench
