// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/evaluation/submission_check.h"

#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/graph/spark_dsg_json.h"
#include "eval/oracles/ground_truth_prediction.h"
#include "tests/eval/evaluation/scattered_world.h"

namespace hydrabench {
namespace {

using ::testing::HasSubstr;
using Verdict = SubmissionFinding::Verdict;

class SubmissionCheck : public ::testing::Test {
 protected:
  SubmissionFinding finding(const std::string& topic) const {
    for (const SubmissionFinding& found : checkSubmission(labels_, truth_, prediction_)) {
      if (found.topic == topic) return found;
    }
    ADD_FAILURE() << "nothing on " << topic;
    return {};
  }
  std::vector<ObjectNode>& nodes() { return prediction_.graph.objects; }

  LabelSpace labels_ = furnitureLabels();
  GroundTruth truth_ = scatteredWorld();
  Prediction prediction_ = groundTruthPrediction(labels_, truth_);
};

TEST_F(SubmissionCheck, HasNothingToSayOfGroundTruth) {
  for (const SubmissionFinding& found : checkSubmission(labels_, truth_, prediction_)) {
    EXPECT_EQ(found.verdict, Verdict::kPass) << found.topic << ": " << found.message;
    EXPECT_EQ(found.message, "");
  }
}

TEST_F(SubmissionCheck, NamesTheObjectThatIsNotANumber) {
  nodes()[3].mesh.vertices[2].z() = std::numeric_limits<double>::infinity();
  const std::vector<SubmissionFinding> findings = checkSubmission(labels_, truth_, prediction_);
  ASSERT_EQ(findings.size(), 1u);
  EXPECT_EQ(findings[0].verdict, Verdict::kFail);
  EXPECT_THAT(findings[0].message, HasSubstr(std::to_string(nodes()[3].id) + " 'object_3'"));
}

TEST_F(SubmissionCheck, SaysHowToMendMillimetres) {
  for (ObjectNode& node : nodes()) node.mesh = scaled(1000, node.mesh);
  EXPECT_EQ(finding(kPlacementTopic).message,
            "in millimetres: 24 of 24 objects agree with the ground truth after the change, 0 "
            "without; multiply positions and meshes by 0.001");
}

TEST_F(SubmissionCheck, KnowsMillimetresBySizesWhereNothingMatches) {
  // Three objects at the wrong places: a poor method, and in millimetres all the same.
  nodes().resize(3);
  for (ObjectNode& node : nodes()) {
    for (Eigen::Vector3d& vertex : node.mesh.vertices) {
      vertex = 1000 * (vertex + Eigen::Vector3d(4, 5, 6));
    }
  }
  EXPECT_EQ(finding(kPlacementTopic).verdict, Verdict::kFail);
  EXPECT_THAT(finding(kPlacementTopic).message, HasSubstr("in millimetres: the median object is"));
}

TEST_F(SubmissionCheck, KnowsMeshesInMillimetresAboutPlacesInMetres) {
  for (ObjectNode& node : nodes()) {
    const Eigen::Vector3d center = node.box.center();
    for (Eigen::Vector3d& vertex : node.mesh.vertices) {
      vertex = center + 1000 * (vertex - center);
    }
  }
  EXPECT_THAT(finding(kPlacementTopic).message,
              HasSubstr("multiply the mesh points about the centre of their box by 0.001"));
}

TEST_F(SubmissionCheck, DoesNotAccuseFragmentsOfBeingInOtherUnits) {
  for (ObjectNode& node : nodes()) {
    const Eigen::Vector3d center = node.box.center() + Eigen::Vector3d(0.3, 0.3, 0);
    for (Eigen::Vector3d& vertex : node.mesh.vertices) {
      vertex = center + 0.01 * (vertex - center);
    }
  }
  EXPECT_EQ(finding(kPlacementTopic).message, "");
}

TEST_F(SubmissionCheck, RefusesLabelsOfAnotherDataset) {
  for (ObjectNode& node : nodes()) {
    node.label += 100;
    for (Eigen::Vector3d& vertex : node.mesh.vertices) vertex.x() += 50;
  }
  prediction_.graph.label_space = {};
  EXPECT_EQ(finding("labels").verdict, Verdict::kFail);
  EXPECT_EQ(finding("labels").message,
            "none of 24 objects has a label of this dataset: 105, 107, 118; expected 5 chair, 7 "
            "couch, 18 bin");
}

TEST_F(SubmissionCheck, OnlyRemarksOnFurtherLabels) {
  nodes()[0].label = 99;
  EXPECT_EQ(finding("labels").verdict, Verdict::kWarning);
  EXPECT_THAT(finding("labels").message, HasSubstr("1 of 24 objects have labels"));
}

TEST_F(SubmissionCheck, TakesTheFilesOwnNamesAtTheirWord) {
  // Numbered from 0 on, in the order of the dataset: 5 is not in it, 16 and 18 are by chance.
  prediction_.graph.label_space.entries = {{kBin, "chair", {}, true, true},
                                           {kDesk, "bin", {}, true, true}};
  for (ObjectNode& node : nodes()) node.label = node.label == kChair ? kBin : kDesk;
  EXPECT_EQ(finding("labels").verdict, Verdict::kFail);
  EXPECT_THAT(finding("labels").message, HasSubstr("18 for chair (5 here)"));
}

TEST_F(SubmissionCheck, SeesExchangedLabelsByWhereThingsStand) {
  for (ObjectNode& node : nodes()) {
    node.label = node.label == kChair ? kCouch : node.label == kCouch ? kBin : kChair;
  }
  EXPECT_EQ(finding("labels").verdict, Verdict::kFail);
  EXPECT_THAT(finding("labels").message, HasSubstr("7 for 5 chair (12 of 12)"));
}

TEST_F(SubmissionCheck, DoesNotAccuseAMethodThatConfusesClasses) {
  std::vector<Label> confused = {kChair, kCouch, kBin};
  for (std::size_t i = 0; i < nodes().size(); ++i) nodes()[i].label = confused[i % 3];
  EXPECT_EQ(finding("labels").verdict, Verdict::kPass) << finding("labels").message;
  for (ObjectNode& node : nodes()) node.label = kCouch;
  EXPECT_EQ(finding("labels").verdict, Verdict::kPass) << finding("labels").message;
  for (ObjectNode& node : nodes()) node.label = kDesk;
  EXPECT_EQ(finding("labels").verdict, Verdict::kPass) << finding("labels").message;
}

TEST_F(SubmissionCheck, DoesNotAccuseConfusionThatIsNotOneToOne) {
  // Chairs are called couch; of six bins, four as well: 12 of 16 is no numbering.
  for (std::size_t i = 0; i < nodes().size(); ++i) {
    Label& label = nodes()[i].label;
    label = label == kChair ? kCouch : label == kCouch ? kBin : i < 22 ? kCouch : kChair;
  }
  EXPECT_EQ(finding("labels").verdict, Verdict::kPass) << finding("labels").message;
  // Only chairs, half of them called couch, half bin: both for the same class.
  nodes().resize(12);
  for (std::size_t i = 0; i < 12; ++i) nodes()[i].label = i % 2 == 0 ? kCouch : kBin;
  EXPECT_EQ(finding("labels").verdict, Verdict::kPass) << finding("labels").message;
}

TEST_F(SubmissionCheck, RemarksOnObjectsListedTwice) {
  nodes().push_back(nodes()[4]);
  nodes().back().id = objectNodeId(99);
  EXPECT_EQ(finding("each object once").verdict, Verdict::kWarning);
  EXPECT_THAT(finding("each object once").message, HasSubstr("1 of 25 objects"));
}

TEST_F(SubmissionCheck, RemarksOnClosedMeshesTurnedInsideOut) {
  for (Eigen::Vector3i& face : nodes()[2].mesh.faces) std::swap(face[0], face[1]);
  nodes()[5].mesh.faces.pop_back();  // open: nothing to say
  for (Eigen::Vector3i& face : nodes()[5].mesh.faces) std::swap(face[0], face[1]);
  EXPECT_EQ(finding("closed meshes look outwards").verdict, Verdict::kWarning);
  EXPECT_THAT(finding("closed meshes look outwards").message, HasSubstr("1 of 24 objects"));
}

TEST_F(SubmissionCheck, HasNothingToSayOfAnEmptyPrediction) {
  nodes().clear();
  for (const SubmissionFinding& found : checkSubmission(labels_, truth_, prediction_)) {
    EXPECT_EQ(found.verdict, Verdict::kPass) << found.topic << ": " << found.message;
  }
}

}  // namespace
}  // namespace hydrabench
