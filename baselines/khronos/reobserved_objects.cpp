// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "baselines/khronos/reobserved_objects.h"

#include <algorithm>
#include <utility>

namespace hydrabench {

bool ReobservedObjects::seenTogether(const Object& a, const Object& b) {
  return std::any_of(a.seen.begin(), a.seen.end(), [&](const Interval& i) {
    return std::any_of(b.seen.begin(), b.seen.end(), [&](const Interval& j) {
      return i.first_ns <= j.last_ns && j.first_ns <= i.last_ns;
    });
  });
}

void ReobservedObjects::merge(Object&& from, Object& into) {
  append(from.node.mesh, into.node.mesh);
  into.seen.insert(into.seen.end(), from.seen.begin(), from.seen.end());
  into.node.box = bounds(into.node.mesh);
  into.node.T_world_object.translation() = into.node.box.center();
  into.node.first_observed_ns = std::min(into.node.first_observed_ns, from.node.first_observed_ns);
  into.node.last_observed_ns = std::max(into.node.last_observed_ns, from.node.last_observed_ns);
}

void ReobservedObjects::add(ObjectNode object) {
  const Interval seen{object.first_observed_ns, object.last_observed_ns};
  Object added{std::move(object), {seen}};
  while (true) {
    auto partner = objects_.end();
    double best_iou = 0;
    for (auto it = objects_.begin(); it != objects_.end(); ++it) {
      if (it->node.label != added.node.label || seenTogether(*it, added)) continue;
      const double iou = boxIou(it->node.box, added.node.box);
      if (iou >= min_iou_ && iou > best_iou) {
        partner = it;
        best_iou = iou;
      }
    }
    if (partner == objects_.end()) break;
    Object whole = std::move(*partner);
    objects_.erase(partner);
    if (whole.node.id > added.node.id) std::swap(whole, added);
    merge(std::move(added), whole);
    added = std::move(whole);
    ++num_merged_;
  }
  const auto place =
      std::upper_bound(objects_.begin(), objects_.end(), added.node.id,
                       [](ObjectId id, const Object& other) { return id < other.node.id; });
  objects_.insert(place, std::move(added));
}

std::vector<ObjectNode> ReobservedObjects::nodes() const {
  std::vector<ObjectNode> nodes;
  for (const Object& object : objects_) nodes.push_back(object.node);
  return nodes;
}

}  // namespace hydrabench
