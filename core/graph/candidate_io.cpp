// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/graph/candidate_io.h"

#include <algorithm>
#include <limits>
#include <string_view>

#include "core/geometry/mesh_io.h"
#include "core/graph/json_text.h"
#include "core/io/atomic_file.h"
#include "core/io/json_field.h"

namespace hydrabench {
namespace fs = std::filesystem;

namespace {

constexpr const char* kMeshFolder = "candidates";

/// 3 x 4, row by row.
void write(JsonText& json, const char* key, const Transform& T) {
  json.key(key).beginArray();
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 4; ++column) json.value(T.matrix()(row, column));
  }
  json.endArray();
}

Transform transformIn(const JsonField& field) {
  if (field.size() != 12) field.fail("twelve numbers");
  Transform T = Transform::Identity();
  for (int i = 0; i < 12; ++i) T.matrix()(i / 4, i % 4) = field.item(std::size_t(i)).number();
  return T;
}

void write(JsonText& json, const char* key, const Camera& camera) {
  json.key(key).beginObject();
  json.member("width", camera.width).member("height", camera.height);
  json.member("fx", camera.fx).member("fy", camera.fy);
  json.member("cx", camera.cx).member("cy", camera.cy);
  json.endObject();
}

int smallInteger(const JsonField& field) {
  const std::uint64_t value = field.unsignedInteger("a number of pixels");
  if (value > 1'000'000) field.fail("a number of pixels");
  return static_cast<int>(value);
}

Camera cameraIn(const JsonField& field) {
  return {smallInteger(field.at("width")), smallInteger(field.at("height")),
          field.at("fx").number(),         field.at("fy").number(),
          field.at("cx").number(),         field.at("cy").number()};
}

/// Lengths of the runs in row order: of zeros, of ones, of zeros, ...
void writeMask(JsonText& json, const ShapeCandidate& candidate) {
  json.key("mask").beginObject();
  json.member("u", candidate.mask_u).member("v", candidate.mask_v);
  json.member("width", candidate.mask.width()).member("height", candidate.mask.height());
  json.key("runs").beginArray();
  std::uint8_t value = 0;
  std::size_t length = 0;
  for (const std::uint8_t pixel : candidate.mask) {
    if ((pixel != 0) != (value != 0)) {
      json.value(length);
      value = pixel;
      length = 0;
    }
    ++length;
  }
  if (length > 0) json.value(length);
  json.endArray().endObject();
}

void readMask(const JsonField& field, ShapeCandidate& candidate) {
  candidate.mask_u = smallInteger(field.at("u"));
  candidate.mask_v = smallInteger(field.at("v"));
  const int width = smallInteger(field.at("width"));
  const int height = smallInteger(field.at("height"));
  if (candidate.mask_u + width > candidate.camera.width ||
      candidate.mask_v + height > candidate.camera.height) {
    field.complain("reaches beyond the camera's image");
  }
  candidate.mask = Image<std::uint8_t>(width, height);
  const JsonField runs = field.at("runs");
  std::size_t begin = 0;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const std::uint64_t length = runs.item(i).unsignedInteger();
    if (length > candidate.mask.size() - begin) break;
    std::fill_n(candidate.mask.data() + begin, length, static_cast<std::uint8_t>(i % 2));
    begin += length;
    if (i + 1 == runs.size() && begin == candidate.mask.size()) return;
  }
  if (candidate.mask.size() > 0) runs.complain("the runs do not add up to the mask's pixels");
}

std::string meshName(const ShapeCandidate& candidate, const char* suffix) {
  return fmt::format("{}/track_{:06}{}.ply", kMeshFolder, candidate.track, suffix);
}

std::string lineOf(const ShapeCandidate& candidate) {
  JsonText json;
  json.beginObject().member("track", candidate.track).member("label", candidate.label);
  json.member("first_observed_ns", candidate.first_observed_ns);
  json.member("last_observed_ns", candidate.last_observed_ns);
  json.member("observations", candidate.observations);
  json.member("view_stamp_ns", candidate.view_stamp_ns);
  write(json, "camera", candidate.camera);
  write(json, "T_world_camera", candidate.T_world_camera);
  json.member("view_volume_m3", candidate.view_volume_m3);
  writeMask(json, candidate);
  if (candidate.hasEstimate()) {
    write(json, "T_world_object", candidate.T_world_object);
    json.member("scale", candidate.scale).member("mesh", meshName(candidate, ""));
    json.member("inlier_ratio", candidate.inlier_ratio);
    json.member("overlap", candidate.overlap).member("coverage", candidate.coverage);
    if (candidate.depth_residual_m) json.member("depth_residual_m", *candidate.depth_residual_m);
  } else {
    json.member("failure", candidate.failure);
  }
  if (!candidate.partial_mesh.empty()) {
    json.member("partial_mesh", meshName(candidate, "_partial"));
  }
  json.member("accepted", candidate.accepted);
  if (!candidate.reason.empty()) json.member("reason", candidate.reason);
  if (candidate.object) json.member("object", *candidate.object);
  return json.endObject().newline().text();
}

ShapeCandidate candidateIn(const JsonField& field, const fs::path& folder) {
  ShapeCandidate candidate;
  candidate.track = field.at("track").unsignedInteger();
  const std::int64_t label = field.at("label").integer();
  if (label < std::numeric_limits<Label>::min() || label > std::numeric_limits<Label>::max()) {
    field.at("label").fail("a label");
  }
  candidate.label = static_cast<Label>(label);
  candidate.first_observed_ns = field.at("first_observed_ns").integer();
  candidate.last_observed_ns = field.at("last_observed_ns").integer();
  candidate.observations = field.at("observations").unsignedInteger();
  candidate.view_stamp_ns = field.at("view_stamp_ns").integer();
  candidate.camera = cameraIn(field.at("camera"));
  candidate.T_world_camera = transformIn(field.at("T_world_camera"));
  candidate.view_volume_m3 = field.at("view_volume_m3").number();
  readMask(field.at("mask"), candidate);
  if (const auto failure = field.find("failure")) {
    candidate.failure = failure->text();
  } else {
    candidate.T_world_object = transformIn(field.at("T_world_object"));
    candidate.scale = field.at("scale").number();
    candidate.mesh = readMesh(folder / field.at("mesh").text());
    candidate.box = bounds(candidate.mesh);
    candidate.inlier_ratio = field.at("inlier_ratio").number();
    candidate.overlap = field.at("overlap").number();
    candidate.coverage = field.at("coverage").number();
    if (const auto residual = field.find("depth_residual_m")) {
      candidate.depth_residual_m = residual->number();
    }
  }
  if (const auto partial = field.find("partial_mesh")) {
    candidate.partial_mesh = readMesh(folder / partial->text());
  }
  candidate.accepted = field.at("accepted").boolean();
  if (const auto reason = field.find("reason")) candidate.reason = reason->text();
  if (const auto object = field.find("object")) candidate.object = object->unsignedInteger();
  return candidate;
}

}  // namespace

void writeCandidates(const fs::path& folder, const std::vector<ShapeCandidate>& candidates) {
  std::string lines;
  for (const ShapeCandidate& candidate : candidates) {
    lines += lineOf(candidate);
    if (candidate.hasEstimate()) writeMesh(folder / meshName(candidate, ""), candidate.mesh);
    if (!candidate.partial_mesh.empty()) {
      writeMesh(folder / meshName(candidate, "_partial"), candidate.partial_mesh);
    }
  }
  writeFileAtomic(folder / kCandidatesFile, lines);
}

std::vector<ShapeCandidate> readCandidates(const fs::path& folder) {
  const fs::path file = folder / kCandidatesFile;
  std::vector<ShapeCandidate> candidates;
  if (!fs::exists(file)) return candidates;
  const std::string text = readFile(file);
  std::string_view rest = text;
  for (std::size_t number = 1; !rest.empty(); ++number) {
    const std::string_view line = rest.substr(0, rest.find('\n'));
    rest.remove_prefix(std::min(rest.size(), line.size() + 1));
    if (line.empty()) continue;
    const std::string place = fmt::format("{}:{}: ", file.string(), number);
    const nlohmann::json json = nlohmann::json::parse(line, nullptr, /*allow_exceptions=*/false);
    if (json.is_discarded()) throw InputError(place + "is not JSON, expected one object per line");
    candidates.push_back(candidateIn(JsonField(json, place), folder));
  }
  return candidates;
}

}  // namespace hydrabench
