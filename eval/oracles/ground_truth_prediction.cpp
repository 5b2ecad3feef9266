// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/oracles/ground_truth_prediction.h"

#include "core/graph/spark_dsg_json.h"

namespace hydrabench {

Prediction groundTruthPrediction(const LabelSpace& label_space, const GroundTruth& truth) {
  Prediction prediction;
  prediction.method = "ground_truth";
  prediction.graph.label_space = label_space;
  for (const GroundTruthObject& object : truth.objects) {
    const LabelSpace::Entry* entry = label_space.find(object.label);
    if (!entry || !entry->is_object) continue;
    ObjectNode node;
    node.id = objectNodeId(prediction.graph.objects.size());
    node.label = object.label;
    node.name = object.name;
    node.T_world_object = object.T_world_object;
    node.mesh = transformed(object.T_world_object, *object.mesh);
    node.box = bounds(node.mesh);
    prediction.graph.objects.push_back(std::move(node));
  }
  return prediction;
}

}  // namespace hydrabench
