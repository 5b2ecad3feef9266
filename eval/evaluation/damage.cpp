// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/evaluation/damage.h"

#include <limits>
#include <map>
#include <utility>

#include "core/graph/spark_dsg_json.h"

namespace hydrabench {
namespace {

std::vector<DetectionObject> detectionsOf(const Prediction& prediction) {
  std::vector<DetectionObject> result;
  for (const ObjectNode& node : prediction.graph.objects) {
    // Furniture that is not scored may come without a mesh.
    result.push_back(node.mesh.vertices.empty() ? DetectionObject{node.id, node.label}
                                                : detectionObject(node.id, node.label, node.mesh));
  }
  return result;
}

std::vector<std::array<std::size_t, 2>> closestOfEachClass(
    const std::vector<DetectionObject>& objects) {
  struct Closest {
    std::array<std::size_t, 2> pair = {0, 0};
    double distance = std::numeric_limits<double>::infinity();
  };
  std::map<Label, Closest> by_label;
  for (std::size_t a = 0; a < objects.size(); ++a) {
    for (std::size_t b = a + 1; b < objects.size(); ++b) {
      if (objects[a].label != objects[b].label) continue;
      const double distance = (objects[a].center - objects[b].center).norm();
      Closest& closest = by_label[objects[a].label];
      if (distance < closest.distance) closest = {{a, b}, distance};
    }
  }
  std::vector<std::array<std::size_t, 2>> pairs;
  for (const auto& [label, closest] : by_label) pairs.push_back(closest.pair);
  return pairs;
}

}  // namespace

DamagedPrediction changed(const Prediction& prediction, const CoordinateChange& change) {
  DamagedPrediction result{prediction, detectionsOf(prediction)};
  for (std::size_t i = 0; i < result.estimates.size(); ++i) {
    ObjectNode& node = result.prediction.graph.objects[i];
    for (Eigen::Vector3d& vertex : node.mesh.vertices) {
      vertex = change.linear * vertex + change.offset;
    }
    node.box = bounds(node.mesh);
    result.estimates[i].center = change.linear * result.estimates[i].center + change.offset;
  }
  return result;
}

DamagedPrediction emptied(const Prediction& prediction) {
  DamagedPrediction result{prediction, {}};
  result.prediction.graph.objects.clear();
  return result;
}

DamagedPrediction doubled(const Prediction& prediction) {
  DamagedPrediction result{prediction, detectionsOf(prediction)};
  for (std::size_t i = 0; i < prediction.graph.objects.size(); ++i) {
    ObjectNode node = prediction.graph.objects[i];
    node.id = objectNodeId(prediction.graph.objects.size() + i);
    result.estimates.push_back(result.estimates[i]);
    result.estimates.back().id = node.id;
    result.prediction.graph.objects.push_back(std::move(node));
  }
  return result;
}

MergedPrediction merged(const Prediction& prediction) {
  const std::vector<DetectionObject> objects = detectionsOf(prediction);
  MergedPrediction result;
  result.prediction = prediction;
  result.prediction.graph.objects.clear();
  std::map<std::size_t, std::size_t> partner_of;
  std::vector<char> taken(objects.size(), 0);
  for (const auto& [first, second] : closestOfEachClass(objects)) {
    partner_of[first] = second;
    taken[second] = 1;
  }
  for (std::size_t i = 0; i < objects.size(); ++i) {
    if (taken[i]) continue;
    ObjectNode node = prediction.graph.objects[i];
    DetectionObject estimate = objects[i];
    if (const auto partner = partner_of.find(i); partner != partner_of.end()) {
      const ObjectNode& other = prediction.graph.objects[partner->second];
      const Aabb box = objectBox(node.mesh).merged(objectBox(other.mesh));
      estimate.center = box.center();
      result.joins.push_back(
          {result.prediction.graph.objects.size(), {objects[i], objects[partner->second]}});
      append(other.mesh, node.mesh);
      node.box = bounds(node.mesh);
    }
    result.prediction.graph.objects.push_back(std::move(node));
    result.estimates.push_back(estimate);
  }
  return result;
}

DamagedPrediction turnedInsideOut(const Prediction& prediction) {
  DamagedPrediction result{prediction, detectionsOf(prediction)};
  for (ObjectNode& node : result.prediction.graph.objects) {
    for (Eigen::Vector3i& face : node.mesh.faces) std::swap(face[1], face[2]);
  }
  return result;
}

Prediction withNan(const Prediction& prediction, std::size_t node) {
  Prediction result = prediction;
  Mesh& mesh = result.graph.objects[node].mesh;
  mesh.vertices[mesh.vertices.size() / 2].y() = std::numeric_limits<double>::quiet_NaN();
  return result;
}

}  // namespace hydrabench
