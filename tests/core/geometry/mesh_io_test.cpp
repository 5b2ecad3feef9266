// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/geometry/mesh_io.h"

#include <limits>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/types/error.h"
#include "tests/support/python_oracle.h"
#include "tests/support/temporary_folder.h"

namespace hydrabench {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

Mesh colouredSphere() {
  Mesh mesh = sphereMesh({0.1, -20.3, 1e-7}, 0.123456789, 2);
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    mesh.colors.push_back({static_cast<std::uint8_t>(i), static_cast<std::uint8_t>(255 - i % 256),
                           static_cast<std::uint8_t>(7 * i)});
  }
  roundToFloat(mesh);
  return mesh;
}

/// Three faces on one edge, a face twice, a vertex nobody uses: what half-edge structures change.
Mesh nonManifoldSoup() {
  Mesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, -1, 0}, {9, 9, 9}};
  mesh.faces = {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}, {0, 1, 2}, {2, 2, 3}};
  return mesh;
}

class RoundTrip : public ::testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Formats, RoundTrip, ::testing::Values("mesh.ply", "mesh.obj", "MESH.PLY"));

TEST_P(RoundTrip, IsBitEqualForFloatCoordinates) {
  const TemporaryFolder folder;
  for (const Mesh& mesh :
       {colouredSphere(), boxMesh(Aabb(Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(1, 2, 3))),
        nonManifoldSoup()}) {
    writeMesh(folder / GetParam(), mesh);
    const Mesh back = readMesh(folder / GetParam());
    EXPECT_EQ(back.vertices, mesh.vertices);
    EXPECT_EQ(back.faces, mesh.faces);
    EXPECT_EQ(back.colors, mesh.colors);
  }
}

TEST_P(RoundTrip, KeepsAnEmptyMesh) {
  const TemporaryFolder folder;
  writeMesh(folder / GetParam(), Mesh());
  EXPECT_TRUE(readMesh(folder / GetParam()).vertices.empty());
}

constexpr const char* kPlySquare = R"(ply
format ascii 1.0
comment a square, with properties that mean nothing to us
element vertex 4
property double x
property double y
property double z
property float quality
property uchar red
property uchar green
property uchar blue
element face 1
property list uchar uint vertex_index
property int flags
element edge 1
property int vertex1
property int vertex2
end_header
0 0 0 0.5 1 2 3
1 0 0 0.5 1 2 3
1 1 0 0.5 1 2 3
0 1 0.1 0.5 1 2 3
4 0 1 2 3 -7
0 1
)";

Mesh readText(const std::string& name, const std::string& content) {
  const TemporaryFolder folder;
  writeText(folder / name, content);
  return readMesh(folder / name);
}

TEST(ReadMesh, TriangulatesPolygonsAsFans) {
  const Mesh mesh = readText("square.ply", kPlySquare);
  EXPECT_THAT(mesh.faces,
              ::testing::ElementsAre(Eigen::Vector3i(0, 1, 2), Eigen::Vector3i(0, 2, 3)));
  EXPECT_EQ(mesh.vertices[3], Eigen::Vector3d(0, 1, 0.1));
  EXPECT_EQ(mesh.colors[3], (Rgb{1, 2, 3}));
}

TEST(ReadMesh, ReadsBigEndianPly) {
  std::string content =
      "ply\r\nformat binary_big_endian 1.0\r\nelement vertex 3\r\nproperty short x\r\n"
      "property short y\r\nproperty short z\r\nelement face 1\r\n"
      "property list uchar ushort vertex_indices\r\nend_header\r\n";
  for (const char c : {0, 1, 0, 0, 0, 0, 0, 0, 1, 2, 0, 0, 0, 0, 0, 0, 0, 3, 3, 0, 0, 0, 1, 0, 2})
    content += c;
  const Mesh mesh = readText("big.ply", content);
  EXPECT_EQ(mesh.vertices[0], Eigen::Vector3d(1, 0, 0));
  EXPECT_EQ(mesh.vertices[1], Eigen::Vector3d(0, 258, 0));
  EXPECT_EQ(mesh.faces[0], Eigen::Vector3i(0, 1, 2));
}

TEST(ReadMesh, ReadsObjWithTextureNormalsAndNegativeIndices) {
  const Mesh mesh =
      readText("a.obj",
               "# comment\nmtllib a.mtl\no thing\nv 0 0 0\r\nv +1 0 0\nv 1 1e0 0\nv 0 1 0\n"
               "vt 0 0\nvn 0 0 1\nusemtl m\ns off\nf 1/1/1 2//1 3/1 -1\nf -4 -3 -2");
  EXPECT_EQ(mesh.vertices.size(), 4u);
  EXPECT_THAT(mesh.faces, ::testing::ElementsAre(Eigen::Vector3i(0, 1, 2), Eigen::Vector3i(0, 2, 3),
                                                 Eigen::Vector3i(0, 1, 2)));
  EXPECT_TRUE(mesh.colors.empty());
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

/// The one line a bad file must give, the folder cut off.
std::string faultOf(const std::string& name, const std::string& content) {
  const TemporaryFolder folder;
  writeText(folder / name, content);
  const std::string message = messageOf<InputError>([&] { readMesh(folder / name); });
  EXPECT_THAT(message, ::testing::StartsWith((folder / name).string() + ": "));
  EXPECT_THAT(message, Not(HasSubstr("\n")));
  return message.substr(std::min(message.size(), (folder / name).string().size() + 2));
}

TEST(ReadMesh, NamesAMissingFile) {
  EXPECT_THAT(messageOf<InputError>([] { readMesh("/nowhere/chair.ply"); }),
              HasSubstr("/nowhere/chair.ply"));
}

TEST(ReadMesh, NamesAnUnknownExtension) {
  EXPECT_EQ(faultOf("a.stl", "solid"), "extension '.stl', expected .ply or .obj");
  EXPECT_EQ(messageOf<OutputError>([] { writeMesh("a.stl", Mesh()); }),
            "a.stl: extension '.stl', expected .ply or .obj");
}

TEST(ReadMesh, RefusesAnEmptyFile) {
  EXPECT_EQ(faultOf("a.ply", ""), "the file is empty, expected a mesh");
  EXPECT_EQ(faultOf("a.obj", ""), "the file is empty, expected a mesh");
}

TEST(ReadMesh, RefusesAForeignFile) {
  EXPECT_EQ(faultOf("a.ply", "\x89PNG\n"), "does not begin with 'ply'");
  EXPECT_EQ(faultOf("a.obj", "\x89PNG\n"), "line 1: not OBJ, and the file has no vertex");
}

TEST(ReadMesh, DoesNotBelieveAHeaderThatStatesTooMuch) {
  EXPECT_THAT(
      faultOf("a.ply", replaced(kPlySquare, "vertex 4", "vertex 1000000000000")),
      HasSubstr("states 1000000000000 rows of element vertex, but the file has room for at most"));
  EXPECT_THAT(
      faultOf("a.ply", replaced(kPlySquare, "vertex 4", "vertex 99999999999999999999999")),
      HasSubstr("header states '99999999999999999999999' for element vertex, expected a count"));
  EXPECT_THAT(faultOf("a.ply", replaced(kPlySquare, "vertex 4", "vertex -4")),
              HasSubstr("header states '-4'"));
  EXPECT_THAT(faultOf("a.ply", replaced(kPlySquare, "4 0 1 2 3 -7", "4000000000 0 1 2 3 -7")),
              HasSubstr("states 4000000000 list values, but the file has room for at most"));
}

TEST(ReadMesh, NoticesATruncatedFile) {
  const TemporaryFolder folder;
  for (const char* name : {"a.ply", "b.ply"}) {
    writeMesh(folder / "whole.ply",
              boxMesh(Aabb(Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(1, 1, 1))));
    const std::string whole =
        name[0] == 'a' ? hydrabench::readText(folder / "whole.ply") : kPlySquare;
    // Wherever a binary file is cut it is an error; in text the last number may lose digits
    // unnoticed.
    for (std::size_t size = 1; size + 3 < whole.size(); size += 5) {
      writeText(folder / name, whole.substr(0, size));
      EXPECT_THROW(readMesh(folder / name), InputError) << size;
    }
  }
  EXPECT_EQ(faultOf("a.ply", std::string(kPlySquare).substr(0, 60)),
            "ends within its header, expected 'end_header'");
}

TEST(ReadMesh, RefusesCoordinatesThatAreNotFinite) {
  EXPECT_EQ(faultOf("a.ply", replaced(kPlySquare, "1 1 0 0.5", "1 nan 0 0.5")),
            "vertex 2 is (1, nan, 0), expected finite coordinates");
  EXPECT_EQ(faultOf("a.ply", replaced(kPlySquare, "1 1 0 0.5", "1 1e999 0 0.5")),
            "vertex 2 is (1, inf, 0), expected finite coordinates");
  EXPECT_EQ(faultOf("a.obj", "v 0 0 0\nv 0 -inf 0\n"),
            "vertex 1 is (0, -inf, 0), expected finite coordinates");
  EXPECT_EQ(faultOf("a.obj", "v 0 0 zero\n"), "line 1: vertex has 'zero', expected a number");
}

TEST(ReadMesh, RefusesIndicesOutOfRange) {
  EXPECT_EQ(faultOf("a.ply", replaced(kPlySquare, "4 0 1 2 3", "4 0 1 2 4")),
            "element face row 0 of 1: refers to vertex 4, expected 0 to 3");
  EXPECT_EQ(faultOf("a.ply", replaced(kPlySquare, "4 0 1 2 3", "4 0 1 -1 3")),
            "element face row 0 of 1: refers to vertex -1, expected 0 to 3");
  EXPECT_THAT(faultOf("a.ply", replaced(kPlySquare, "4 0 1 2 3", "4 0 1 4294967295 3")),
              HasSubstr("refers to vertex 4294967295"));
  EXPECT_EQ(faultOf("a.obj", "v 0 0 0\nf 1 1 2\n"), "face 0 refers to vertex 1, expected 0 to 0");
  EXPECT_EQ(faultOf("a.obj", "v 0 0 0\nf 1 1 0\n"),
            "line 2: face refers to vertex '0', expected 1 to 1 or -1 to -1");
  EXPECT_EQ(faultOf("a.obj", "v 0 0 0\nf 1 1 -2\n"),
            "line 2: face refers to vertex '-2', expected 1 to 1 or -1 to -1");
  EXPECT_EQ(faultOf("a.obj", "v 0 0 0\nf 1 1 99999999999999999999\n"),
            "line 2: face refers to vertex '99999999999999999999', expected 1 to 1 or -1 to -1");
}

TEST(ReadMesh, RefusesWhatIsNoPolygonOrVertex) {
  EXPECT_EQ(faultOf("a.ply", replaced(kPlySquare, "4 0 1 2 3", "2 0 1")),
            "element face row 0 of 1: has 2 corners, expected 3 or more");
  EXPECT_EQ(faultOf("a.obj", "v 0 0 0\nf 1 1\n"), "line 2: face has 2 corners, expected 3 or more");
  EXPECT_EQ(faultOf("a.ply", replaced(kPlySquare, "double z", "double w")),
            "header gives element vertex no x, y and z");
  EXPECT_EQ(faultOf("a.ply", replaced(kPlySquare, "double z", "quad z")),
            "header names the type 'quad', expected a PLY type such as float");
  EXPECT_EQ(faultOf("a.ply", replaced(kPlySquare, "ascii", "binary")),
            "header names the format 'binary', expected ascii or binary_*_endian");
}

TEST(WriteMesh, GivesFilesThatOpen3dReadsWithoutAWarning) {
  const TemporaryFolder folder;
  const Mesh mesh = colouredSphere();
  writeMesh(folder / "mesh.ply", mesh);
  writeMesh(folder / "mesh.obj", mesh);
  const OracleAnswer answer = askPython(
      {"open3d"}, R"(
import sys, open3d
for path in sys.stdin.read().split():
    mesh = open3d.io.read_triangle_mesh(path)
    print(len(mesh.vertices), len(mesh.triangles), len(mesh.vertex_colors), mesh.is_watertight())
)",
      fmt::format("{}\n{}\n", (folder / "mesh.ply").string(), (folder / "mesh.obj").string()));
  if (!answer.output) GTEST_SKIP() << answer.reason;
  EXPECT_EQ(*answer.output, "162 320 162 True\n162 320 162 True\n");
  EXPECT_EQ(answer.warnings, "");
}

}  // namespace
}  // namespace hydrabench
