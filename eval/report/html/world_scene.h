// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <deque>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "eval/experiment/result_worlds.h"
#include "eval/report/html/object_table.h"
#include "eval/report/html/page.h"
#include "eval/report/html/shape_set.h"
#include "eval/report/html/view_cuts.h"

namespace hydrabench {

/// How fine the scene of a world is kept.
struct SceneDetail {
  std::size_t object_faces = 800;
  std::size_t scene_faces = 60000;  ///< 0: no scene meshes
  int picture_px = 240;             ///< of a best view; 0: none
};

/// Everything there is to see of a world: true objects, what each method made of them, the views
/// that shapes were estimated from, and distances between surfaces.
class WorldScene {
 public:
  /// Reads the predictions and opens the dataset. Throws InputError for what cannot be read.
  /// @param objects  of the same world; nullptr where nothing was scored. Must outlive this.
  WorldScene(const ResultWorld& world, const ObjectWorld* objects);
  WorldScene(const WorldScene&) = delete;
  WorldScene& operator=(const WorldScene&) = delete;

  struct Packed {
    std::string json;  ///< what is where in the blobs
    std::vector<PageData> blobs;
    std::size_t bytes() const;  ///< of all of it in the page
  };
  /// @param prefix  of the ids of the blobs
  Packed pack(const std::string& prefix, const SceneDetail& detail) const;

  double framePeriod() const;  ///< mean time between frames [s]; 0 where no poses say

 private:
  struct Method {
    Prediction prediction;
    RmccConfig rmcc;
    std::vector<std::optional<std::size_t>> shapes;  ///< of each object; none: without a mesh
    std::optional<std::size_t> scene;                ///< index into scenes_
  };
  /// What an estimate was matched with at some setting, by number of object and truth.
  struct Match {
    std::size_t object = 0;
    std::size_t truth = 0;
    ShapePair shapes;
  };
  struct Contents;
  void load(const std::filesystem::path& path);
  std::vector<ViewCut> cutsOf(int size_px) const;
  static nlohmann::ordered_json objectsOf(const Method& method, Contents& contents);
  nlohmann::ordered_json matchesOf(const Method& method, Contents& contents) const;
  nlohmann::ordered_json candidatesOf(const Method& method, Contents& contents) const;
  std::vector<Match> matchesOf(const Method& method) const;
  std::optional<std::size_t> nearestTruth(const ShapeCandidate& candidate) const;

  std::string dataset_name_;
  std::string seed_;
  OpenedDataset opened_;
  const ObjectWorld* objects_;
  std::vector<const GroundTruthObject*> truths_;
  std::vector<Mesh> truth_meshes_;  ///< world frame [m]
  std::deque<Method> methods_;      ///< their meshes stay where they are
  std::vector<const Mesh*> scenes_;
  ShapeSet shapes_;
  std::vector<std::size_t> truth_shapes_;
  std::vector<Aabb> truth_boxes_;
};

}  // namespace hydrabench
