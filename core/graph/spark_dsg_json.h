// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "core/graph/scene_graph.h"

namespace hydrabench {

/// Objects and scene mesh in the JSON of spark_dsg 1.1.3, which Hydra and Khronos write and read
/// themselves. Mesh points of an object stand relative to the centre of its box. Reading accepts
/// AABB, OBB and RAABB boxes, ObjectNodeAttributes without a mesh, and mesh_connections into the
/// scene mesh (Hydra). Throws InputError naming file, node and field for: a missing header,
/// duplicate or non-integer ids, faces out of range, non-finite numbers, a label that is no
/// integer.
SceneGraph readSparkDsg(const std::filesystem::path& path);

/// Atomic. Ids are 64-bit integers in the text; doubles are written so that they read back
/// bit-equal.
void writeSparkDsg(const std::filesystem::path& path, const SceneGraph& graph);

/// Node id with the symbol of the objects layer: ('O' << 56) | index.
ObjectId objectNodeId(std::uint64_t index);

/// Prediction folder: scene_graph.json (and prediction.json with the method's name, and the
/// candidates, see candidate_io.h). A bare scene_graph.json is accepted as well.
Prediction readPrediction(const std::filesystem::path& path);
/// Its prediction.json.
struct PredictionDescription {
  std::string method;
  std::vector<std::string> notes;
};
PredictionDescription readPredictionDescription(const std::filesystem::path& folder);
void writePredictionDescription(const std::filesystem::path& folder,
                                const PredictionDescription& description);
/// Without the graph, for what is decided from the candidates anew: a graph of full meshes takes
/// long to read.
Prediction readCandidatePrediction(const std::filesystem::path& folder);
void writePrediction(const std::filesystem::path& folder, const Prediction& prediction);
/// The same into a folder that the caller makes appear.
void fillPredictionFolder(const std::filesystem::path& folder, const Prediction& prediction);

}  // namespace hydrabench
