// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include <cstring>
#include <string>
#include <vector>

#include "core/graph/candidate_io.h"
#include "core/graph/json_text.h"
#include "core/graph/spark_dsg_json.h"
#include "core/io/atomic_file.h"
#include "core/io/json_field.h"

namespace hydrabench {
namespace fs = std::filesystem;

namespace {
constexpr const char* kGraphFile = "scene_graph.json";
constexpr const char* kPredictionFile = "prediction.json";
constexpr const char* kOccupiedFile = "occupied.bin";

/// The side of a voxel, then x, y, z of each centre; all float32, little endian [m].
void writeOccupied(const fs::path& folder, const SceneGraph& graph) {
  std::vector<float> numbers = {static_cast<float>(graph.occupied_voxel_m)};
  numbers.reserve(1 + 3 * graph.occupied.size());
  for (const Eigen::Vector3f& p : graph.occupied) {
    numbers.insert(numbers.end(), {p.x(), p.y(), p.z()});
  }
  std::string bytes(numbers.size() * sizeof(float), 0);
  std::memcpy(bytes.data(), numbers.data(), bytes.size());
  writeFileAtomic(folder / kOccupiedFile, bytes);
}

void readOccupied(const fs::path& folder, SceneGraph& graph) {
  const fs::path file = folder / kOccupiedFile;
  if (!fs::exists(file)) return;
  const std::string bytes = readFile(file);
  if (bytes.size() % (3 * sizeof(float)) != sizeof(float)) {
    throw InputError(fmt::format("{}: {} bytes; expected 4 for the side of a voxel and 12 for each",
                                 file.string(), bytes.size()));
  }
  std::vector<float> numbers(bytes.size() / sizeof(float));
  std::memcpy(numbers.data(), bytes.data(), bytes.size());
  graph.occupied_voxel_m = numbers[0];
  for (std::size_t i = 1; i < numbers.size(); i += 3) {
    graph.occupied.emplace_back(numbers[i], numbers[i + 1], numbers[i + 2]);
  }
}

}  // namespace

PredictionDescription readPredictionDescription(const fs::path& folder) {
  const fs::path file = folder / kPredictionFile;
  const nlohmann::json json = parseJsonFile(file);
  const JsonField field(json, file.string() + ": ");
  PredictionDescription description;
  description.method = field.at("method").text();
  if (const auto notes = field.find("notes")) {
    for (std::size_t i = 0; i < notes->size(); ++i) {
      description.notes.push_back(notes->item(i).text());
    }
  }
  return description;
}

void writePredictionDescription(const fs::path& folder, const PredictionDescription& description) {
  JsonText json;
  json.beginObject().member("method", description.method).key("notes").beginArray();
  for (const std::string& note : description.notes) json.value(note);
  json.endArray().endObject().newline();
  writeFileAtomic(folder / kPredictionFile, json.text());
}

Prediction readPrediction(const fs::path& path) {
  Prediction prediction;
  const bool is_folder = fs::is_directory(path);
  if (path.extension() == ".sparkdsg") {
    throw InputError(
        fmt::format("{}: the binary format of spark_dsg, expected its JSON; save the "
                    "graph there under a name that ends in .json",
                    path.string()));
  }
  const fs::path graph_file = is_folder ? path / kGraphFile : path;
  const fs::path folder = fs::absolute(graph_file).lexically_normal().parent_path();
  if (is_folder && !fs::exists(graph_file)) {
    throw InputError(fmt::format("{}: no {} in this folder", path.string(), kGraphFile));
  }
  prediction.graph = readSparkDsg(graph_file);
  // Without prediction.json (a file of Hydra or Khronos) the name people gave to folder or file has
  // to serve.
  prediction.method =
      graph_file.filename() == kGraphFile ? folder.filename().string() : graph_file.stem().string();
  if (graph_file.filename() == kGraphFile && fs::exists(folder / kPredictionFile)) {
    const PredictionDescription description = readPredictionDescription(folder);
    prediction.method = description.method;
    prediction.notes = description.notes;
  }
  if (graph_file.filename() == kGraphFile) {
    prediction.candidates = readCandidates(folder);
    readOccupied(folder, prediction.graph);
  }
  return prediction;
}

Prediction readCandidatePrediction(const fs::path& folder) {
  const PredictionDescription description = readPredictionDescription(folder);
  Prediction prediction;
  prediction.method = description.method;
  prediction.notes = description.notes;
  prediction.candidates = readCandidates(folder);
  return prediction;
}

void fillPredictionFolder(const fs::path& folder, const Prediction& prediction) {
  writeSparkDsg(folder / kGraphFile, prediction.graph);
  writePredictionDescription(folder, {prediction.method, prediction.notes});
  if (!prediction.candidates.empty()) writeCandidates(folder, prediction.candidates);
  if (!prediction.graph.occupied.empty()) writeOccupied(folder, prediction.graph);
}

void writePrediction(const fs::path& folder, const Prediction& prediction) {
  AtomicFolder result(folder);
  fillPredictionFolder(result.temporary(), prediction);
  result.commit();
}

}  // namespace hydrabench
