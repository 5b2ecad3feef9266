// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "core/config/config_reader.h"
#include "core/geometry/box.h"
#include "core/mapping/map_mesh.h"
#include "core/types/ids.h"

namespace hydrabench {

/// Objects as sets of vertices of the map: Hydra's MeshSegmenter, and the merge of objects that its
/// backend proposes.
class MeshObjects {
 public:
  struct Config {
    double cluster_tolerance_m = 0.25;  ///< vertices at most this far apart are one object
    int min_cluster_size = 40;          ///< vertices
    int max_cluster_size = 100000;
    bool merge_revisited = true;  ///< active objects with archived ones
  };
  struct Node {
    std::uint64_t number = 0;  ///< order of appearance
    Label label = kUnknownLabel;
    std::vector<VertexId> vertices;  ///< ascending; alive and of this label at the last update
    Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< mean of the vertices [m]
    Aabb box;                                            ///< of the vertices [m]
    bool active = true;                                  ///< some vertex is
    std::int64_t first_observed_ns = 0;
    std::int64_t last_observed_ns = 0;  ///< when a vertex was last added
  };
  /// @param labels  of the classes that are objects
  MeshObjects(const Config& config, std::vector<Label> labels);

  /// After the mesh has changed and blocks were archived: nodes whose vertices are all frozen are
  /// active no more. Clusters the mesh's active vertices, label by label, and gives each
  /// cluster to the first active node of that label whose box contains the cluster's centroid, or
  /// to a new node. Then merges active nodes of which one's box contains the other's position, lets
  /// go of vertices that are gone and of nodes too small, and merges each active node with the
  /// nearest archived one of its label on the same terms.
  void update(const MapMesh& mesh, std::int64_t stamp_ns);
  /// Lets go of what is gone, no more: after the last vertices were archived.
  void refresh(const MapMesh& mesh);

  const std::vector<Node>& nodes() const { return nodes_; }  ///< ascending numbers

 private:
  using Clusters = std::vector<std::vector<VertexId>>;
  std::map<Label, Clusters> clusters(const MapMesh& mesh) const;
  void associate(const MapMesh& mesh, Label label, std::vector<VertexId> cluster,
                 std::int64_t stamp_ns);
  void mergeActive(const MapMesh& mesh);
  void mergeRevisited(const MapMesh& mesh);

  Config config_;
  std::vector<Label> labels_;  // ascending
  std::vector<Node> nodes_;
  std::uint64_t next_number_ = 0;
};

void read(ConfigReader& reader, MeshObjects::Config& config);

}  // namespace hydrabench
