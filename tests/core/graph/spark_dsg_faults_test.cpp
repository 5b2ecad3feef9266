// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/graph/spark_dsg_json.h"
#include "core/types/error.h"
#include "tests/support/temporary_folder.h"

namespace hydrabench {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

const std::string kNode = "node 5692549928996306947 (O3): ";

/// The one line that reading the Khronos sample gives after `original` in it was replaced.
class SparkDsgFaults : public ::testing::Test {
 protected:
  std::string faultOf(const std::string& original, const std::string& replacement) {
    std::string text =
        readText(std::filesystem::path(HYDRABENCH_TEST_DATA_DIR) / "graphs/khronos.json");
    const std::size_t at = text.find(original);
    EXPECT_NE(at, std::string::npos) << original;
    return faultIn(text.replace(at, original.size(), replacement));
  }
  std::string faultIn(const std::string& text) {
    writeText(folder_ / "g.json", text);
    const std::string message = messageOf<InputError>([&] { readSparkDsg(folder_ / "g.json"); });
    const std::string file = (folder_ / "g.json").string() + ": ";
    EXPECT_THAT(message, StartsWith(file));
    EXPECT_THAT(message, Not(HasSubstr("\n")));
    return message.substr(std::min(file.size(), message.size()));
  }

 private:
  TemporaryFolder folder_;
};

TEST_F(SparkDsgFaults, MissingHeader) {
  EXPECT_EQ(faultOf("SPARK_DSG_header", "header"),
            "no SPARK_DSG_header, expected a scene graph of spark_dsg 1.1");
  EXPECT_EQ(faultIn(R"({"nodes": [], "layer_ids": [2]})"),
            "no SPARK_DSG_header: the format before spark_dsg 1.1; load and save it once there");
  EXPECT_THAT(faultIn("[1, 2]"), HasSubstr("no SPARK_DSG_header"));
}

TEST_F(SparkDsgFaults, DuplicateId) {
  EXPECT_EQ(faultOf("5692549928996306948", "5692549928996306947"),
            "nodes[2].id: node 5692549928996306947 (O3) is in the file already");
  EXPECT_EQ(faultOf("5692549928996306948", "8070450532247928832"),
            "nodes[2].id: node 8070450532247928832 (p0) is in the file already");
}

TEST_F(SparkDsgFaults, IdThatIsNoInteger) {
  EXPECT_EQ(faultOf("5692549928996306947", "5.692549928996307e18"),
            "nodes[1].id: expected a 64-bit integer, found 5.692549928996307e+18");
  EXPECT_EQ(faultOf("5692549928996306947", "\"O3\""),
            "nodes[1].id: expected a 64-bit integer, found \"O3\"");
  EXPECT_EQ(faultOf("5692549928996306947", "-1"),
            "nodes[1].id: expected a 64-bit integer, found -1");
  EXPECT_THAT(faultOf("5692549928996306947", "36893488147419103232"),
              HasSubstr("nodes[1].id: expected a 64-bit integer, found 3.68"));
}

TEST_F(SparkDsgFaults, FaceOutOfRange) {
  EXPECT_EQ(
      faultOf("[1, 2, 3]]", "[1, 2, 4]]"),
      kNode + "attributes.mesh.faces[1][2]: expected the index of one of the 4 points, found 4");
  EXPECT_EQ(
      faultOf("[1, 2, 3]]", "[1, -2, 3]]"),
      kNode + "attributes.mesh.faces[1][1]: expected the index of one of the 4 points, found -2");
  EXPECT_EQ(
      faultOf("[1, 2, 3]]", "[1, 2.0, 3]]"),
      kNode + "attributes.mesh.faces[1][1]: expected the index of one of the 4 points, found 2.0");
  EXPECT_EQ(faultOf("[1, 2, 3]]", "[1, 2]]"),
            kNode + "attributes.mesh.faces[1]: expected three indices, found a list");
}

TEST_F(SparkDsgFaults, NumbersThatAreNone) {
  EXPECT_EQ(faultOf("[0.25, -0.25, -0.5]", "[0.25, null, -0.5]"),
            kNode + "attributes.mesh.points[1][1]: expected a number, found null");
  for (const std::string word : {"NaN", "-Infinity", "nan", "-inf"}) {
    EXPECT_EQ(faultOf("[0.25, -0.25, -0.5]", "[0.25, " + word + ", -0.5]"),
              kNode + "attributes.mesh.points[1][1]: expected a number, found \"" + word + "\"");
  }
  EXPECT_THAT(faultOf("[0.25, -0.25, -0.5]", "[0.25, NaN, -0.5"), StartsWith("not valid JSON: "));
  EXPECT_THAT(faultOf("[0.25, -0.25, -0.5]", "[0.25, 1e999, -0.5]"),
              StartsWith("not valid JSON: number overflow"));
  EXPECT_EQ(faultOf("\"position\": [1.0, 2.0, 0.5]", "\"position\": [1.0, 2.0]"),
            kNode + "attributes.position: expected three numbers, found a list");
  EXPECT_EQ(faultOf("\"dimensions\": [0.5, 0.5, 1.0]", "\"dimensions\": [0.5, -0.5, 1.0]"),
            kNode + "attributes.bounding_box.dimensions: expected lengths from 0 on, found a list");
  EXPECT_EQ(
      faultOf("{\"w\": 1.0, \"x\"", "{\"w\": 2.0, \"x\""),
      kNode +
          "attributes.bounding_box.world_R_center: expected a unit quaternion, found an object");
}

TEST_F(SparkDsgFaults, MissingFields) {
  EXPECT_EQ(faultOf("\"nodes\"", "\"knots\""), "nodes: missing");
  EXPECT_EQ(faultOf("\"id\": 5692549928996306947,", ""), "nodes[1].id: missing");
  EXPECT_EQ(faultOf("\"type\": \"KhronosObjectAttributes\",", ""),
            kNode + "attributes.type: missing");
  EXPECT_EQ(faultOf("\"position\": [1.0, 2.0, 0.5],", ""), kNode + "attributes.position: missing");
  EXPECT_EQ(faultOf("\"bounding_box\"", "\"box\""), kNode + "attributes.bounding_box: missing");
  EXPECT_EQ(faultOf("\"world_P_center\"", "\"center\""),
            kNode + "attributes.bounding_box.world_P_center: missing");
}

TEST_F(SparkDsgFaults, LabelThatIsNoInteger) {
  const std::string field = kNode + "attributes.semantic_label: expected a label ";
  EXPECT_EQ(faultOf("\"semantic_label\": 5", "\"semantic_label\": \"chair\""),
            field + "(an integer from 0 on), found \"chair\"");
  EXPECT_EQ(faultOf("\"semantic_label\": 5", "\"semantic_label\": 5.0"),
            field + "(an integer from 0 on), found 5.0");
  EXPECT_EQ(faultOf("\"semantic_label\": 5", "\"semantic_label\": -1"),
            field + "(an integer from 0 on), found -1");
  EXPECT_EQ(faultOf("\"semantic_label\": 5", "\"semantic_label\": 4294967294"),
            field + "below 2^31, found 4294967294");
}

TEST_F(SparkDsgFaults, UnknownTypes) {
  EXPECT_EQ(faultOf("KhronosObjectAttributes", "RoomNodeAttributes"),
            kNode +
                "attributes.type: expected KhronosObjectAttributes or ObjectNodeAttributes, "
                "found \"RoomNodeAttributes\"");
  EXPECT_EQ(faultOf("\"AABB\"", "\"SPHERE\""),
            kNode +
                "attributes.bounding_box.type: expected INVALID, AABB, OBB or RAABB, found "
                "\"SPHERE\"");
}

TEST_F(SparkDsgFaults, ColorsThatDoNotFitTheMesh) {
  EXPECT_EQ(faultOf("{\"r\": 1, \"g\": 2, \"b\": 3, \"a\": 255},", ""),
            kNode + "attributes.mesh.colors: 3 colours for 4 points");
  EXPECT_EQ(faultOf("\"r\": 7", "\"r\": 256"),
            kNode + "attributes.mesh.colors[2].r: expected 0 to 255, found 256");
}

TEST_F(SparkDsgFaults, TruncatedFile) {
  const std::string text =
      readText(std::filesystem::path(HYDRABENCH_TEST_DATA_DIR) / "graphs/khronos.json");
  EXPECT_THAT(faultIn(text.substr(0, text.size() / 2)),
              StartsWith("not valid JSON: parse error at"));
  EXPECT_THAT(faultIn(""), StartsWith("not valid JSON: parse error at"));
}

TEST_F(SparkDsgFaults, ConnectionOutsideTheSceneMesh) {
  std::string text =
      readText(std::filesystem::path(HYDRABENCH_TEST_DATA_DIR) / "graphs/hydra.json");
  text.replace(text.find("[4, 1, 2, 3, 2]"), 15, "[4, 1, 2, 5, 2]");
  EXPECT_EQ(faultIn(text),
            "node 5692549928996306944 (O0): attributes.mesh_connections[3]: expected the index of "
            "one of the 5 points of the scene mesh, found 5");
}

TEST(SparkDsg, MissingFileIsNamed) {
  EXPECT_EQ(messageOf<InputError>([] { readSparkDsg("/nowhere/g.json"); }),
            "/nowhere/g.json: cannot read: No such file or directory");
}

}  // namespace
}  // namespace hydrabench
