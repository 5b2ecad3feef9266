// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
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
  if (graph_file.filename() == kGraphFile) prediction.candidates = readCandidates(folder);
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
}

void writePrediction(const fs::path& folder, const Prediction& prediction) {
  AtomicFolder result(folder);
  fillPredictionFolder(result.temporary(), prediction);
  result.commit();
}

}  // namespace hydrabench
