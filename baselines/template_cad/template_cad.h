// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "baselines/template_cad/instance_measurement.h"
#include "baselines/template_cad/instance_tracker.h"
#include "baselines/template_cad/landmark_map.h"
#include "baselines/template_cad/template_model.h"
#include "core/config/config_reader.h"
#include "core/objects/candidate_extractor.h"
#include "core/pipeline/mapping_system.h"

namespace hydrabench {

/// One CAD model per class, put where an instance was: what SlideSLAM (Liu et al., "SlideSLAM:
/// Sparse, Lightweight, Decentralized Metric-Semantic SLAM for Multirobot Navigation", T-RO 2025)
/// does with objects, given poses and instance masks.
///
/// Per frame the points of middling depth of each instance, their median as its place on the
/// floor; assignment per class within a fixed distance; a moving average of the place, by which
/// tracks and landmarks are joined. What was seen long enough is a landmark. One template of fixed
/// size stands in the middle of the extents of the landmark's points, along their main axis.
///
/// Where it departs from SlideSLAM, in its favour unless said otherwise:
///  - Poses are those of the frames. There is no factor graph, so the back-end's estimate is the
///    front-end's; a landmark is made when its track ends, from all its points, instead of being
///    refined frame by frame.
///  - Every frame is used; SlideSLAM's front-end runs at 2 Hz. Its confidences do not exist here.
///  - Candidates have at least 50 pixels and end at 5 m, as in the other methods here: against it.
///  - An instance is large enough if its points extend along world x or y; SlideSLAM tests x only.
///  - Of the points of a track the 10000 that are kept come from all of it, not from its end.
///  - Landmarks that were measured side by side in most frames are never joined.
///  - One landmark model for all classes, matched within 0.75 m (SlideSLAM's labelled points);
///    cuboids would join chairs up to 2 m apart.
///  - The position (mid_extent) is the centre that SlideSLAM's front-end finds together with the
///    yaw, here of all points of a landmark; the moving average lies nearer to the side that was
///    seen.
///  - The yaw is that of the main axis by area moments of the footprint's hull; SlideSLAM's
///    front-end takes the PCA of the hull's corners, which depends on how many there are on a side.
///    Its back-end draws templates at a yaw that has no relation to the object.
///  - Points that lie in one vertical plane span no footprint and give no object: against it.
///  - Templates stand on the ground, whose height is known: ground_z_m, 0 unless configured. Where
///    it is not level they stand on the lowest of the points (z: lowest).
///  - The sizes of the templates are those of ordinary furniture; SlideSLAM's are a constant times
///    the units of its STL files. The templates that come with the program are the nominal shapes
///    of the families the world generator draws from: never an evaluated instance, but on built-in
///    worlds nearer to the truth than any model of a stranger.
///  - SlideSLAM has no couch. The gates for it are ours, after those for its table.
/// There is no mesh of the scene.
class TemplateCad : public MappingSystem {
 public:
  /// Rules for one class. The defaults are those for a class SlideSLAM does not know.
  struct ClassRules {
    std::string class_name;      ///< as in the label space
    std::filesystem::path mesh;  ///< template: object frame [m], z up, x to the front
    double gate_m = 1.0;         ///< between a track's centre and a measurement
    double min_length_m = 0.1;   ///< of the longer side of the points' footprint
    double max_length_m = 3.0;
    double min_height_m = 0.1;  ///< of the points
    double max_height_m = 3.0;

    /// Whether points of this footprint and height may be of the class.
    bool admits(const Footprint& footprint, double height_m) const;
  };
  /// SlideSLAM's gates for chair, plant and bin ("trash bin"), ours for couch; without a mesh.
  static ClassRules publishedRules(const std::string& class_name);

  struct Config {
    double min_range_m = 0.1;  ///< of the sensor; the upper limit is that of the candidates
    CandidateExtractor::Config candidates = instancesAsGiven();
    InstanceMeasurementConfig measurement;
    InstanceTracker::Config tracking;
    LandmarkMap::Config landmarks;
    PlacementConfig placement;
    std::vector<ClassRules> templates;  ///< a class without one gives no objects
  };

  /// Of two templates for one class the first counts; read() refuses them. Throws InputError where
  /// a template cannot be read.
  TemplateCad(const Config& config, const LabelSpace& label_space);

  /// Throws InputError where the frame lacks the image that the candidates are taken from.
  void process(const Frame& frame) override;
  SceneGraph finish() override;
  const StageTimes& stageTimes() const override { return times_; }
  std::vector<std::string> notes() const override;

 private:
  struct Template {
    ClassRules rules;
    TemplateModel model;
  };
  static CandidateExtractor::Config instancesAsGiven();
  static std::map<Label, double> gates(const Config& config, const LabelSpace& label_space);

  Config config_;
  LabelSpace label_space_;
  CandidateExtractor extractor_;
  std::map<Label, Template> templates_;
  InstanceTracker tracker_;
  LandmarkMap landmarks_;
  StageTimes times_;
};

void read(ConfigReader& reader, TemplateCad::Config& config);
/// The list `templates`: class, mesh, and of its rules what is to be other than publishedRules().
void readTemplates(ConfigReader& reader, std::vector<TemplateCad::ClassRules>& templates);

}  // namespace hydrabench
