// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/simulation/office_world.h"

#include <algorithm>
#include <map>

#include "eval/simulation/office_labels.h"
#include "eval/simulation/office_rooms.h"
#include "eval/simulation/office_structure.h"

namespace hydrabench {
namespace {

// Streams of the world's seed.
constexpr std::uint64_t kPlanStream = 1;
constexpr std::uint64_t kStructureStream = 2;
constexpr std::uint64_t kInstanceStream = 3;
constexpr std::uint64_t kRoomStream = 4;
constexpr std::uint64_t kSlotStream = 5;

struct Quota {
  int count = 0;
  Label label = kUnknownLabel;
};

/// Uses slots in order of priority, within one priority in random order, until every class has its
/// number.
void fillSlots(std::vector<Slot> slots, const std::map<std::string, Quota>& quotas, Random random,
               Furnisher& furnisher) {
  for (std::size_t i = slots.size(); i > 1; --i) {
    std::swap(slots[i - 1], slots[random.index(static_cast<std::uint32_t>(i))]);
  }
  std::stable_sort(slots.begin(), slots.end(),
                   [](const Slot& a, const Slot& b) { return a.priority < b.priority; });
  std::map<std::string, int> placed;
  for (const Slot& slot : slots) {
    const Quota& quota = quotas.at(slot.class_name);
    Random slot_random = random.fork(random.bits());
    if (placed[slot.class_name] >= quota.count) continue;
    const auto choice = slot_random.index(static_cast<std::uint32_t>(slot.families.size()));
    const Furnisher::Piece piece = furnisher.draw(slot.families[choice], quota.label);
    if (furnisher.putFirst(piece, slot.room, slot.poses(piece, slot_random), slot.support)) {
      ++placed[slot.class_name];
    }
  }
}

}  // namespace

OfficeConfig OfficeConfig::quick() {
  OfficeConfig config;
  config.world = "quick";
  config.chairs = 8;
  config.couches = 2;
  config.plants = 2;
  config.bins = 3;
  config.computers = 2;
  return config;
}

void read(ConfigReader& reader, OfficeConfig& config) {
  reader.field("chairs", config.chairs, {0, 1000});
  reader.field("couches", config.couches, {0, 1000});
  reader.field("plants", config.plants, {0, 1000});
  reader.field("bins", config.bins, {0, 1000});
  reader.field("computers", config.computers, {0, 1000});
  reader.field("score_computers", config.score_computers);
}

OfficeLayout layOutOffice(const OfficeConfig& config, std::uint64_t seed) {
  const Random random(seed);
  OfficeLayout layout;
  layout.plan = config.world == "quick" ? drawQuickPlan(random.fork(kPlanStream))
                                        : drawOfficePlan(random.fork(kPlanStream));
  const FloorPlan& plan = layout.plan;
  Furnisher furnisher(plan, keepOutAreas(plan), hashSeed(seed, kInstanceStream), config.split);
  std::vector<Slot> slots;
  for (std::size_t i = 0; i < plan.rooms.size(); ++i) {
    RoomFitter fitter(furnisher, plan, static_cast<int>(i), random.fork(kRoomStream).fork(i),
                      slots);
    furnishRoom(plan.rooms[i].kind, fitter);
  }
  namespace id = office_label;
  fillSlots(std::move(slots),
            {{"chair", {config.chairs, id::kChair}},
             {"couch", {config.couches, id::kCouch}},
             {"plant", {config.plants, id::kPlant}},
             {"bin", {config.bins, id::kBin}},
             {"computer", {config.computers, id::kComputer}}},
            random.fork(kSlotStream), furnisher);
  layout.pieces = furnisher.placed();
  return layout;
}

Scene makeOffice(const OfficeConfig& config, std::uint64_t seed) {
  const OfficeLayout layout = layOutOffice(config, seed);
  Scene scene;
  scene.label_space = officeLabelSpace(config.score_computers);
  buildStructure(layout.plan, Random(seed).fork(kStructureStream), scene);
  appendPieces(layout.pieces, layout.plan, scene);
  return scene;
}

}  // namespace hydrabench
