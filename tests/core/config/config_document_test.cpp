// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/config/config_reader.h"
#include "core/types/error.h"
#include "tests/support/temporary_folder.h"

namespace hydrabench {
namespace {

using ::testing::HasSubstr;

struct Noise {
  double level = 1;
  int period = 2;
};
struct World {
  std::string type = "office";
  std::uint64_t seed = 0;
  std::vector<int> rooms{1, 2};
  Noise noise;
};

World read(const ConfigDocument& document) {
  World world;
  ConfigReader reader(document);
  reader.field("type", world.type);
  reader.field("seed", world.seed);
  reader.field("rooms", world.rooms);
  ConfigReader noise = reader.section("noise");
  noise.field("level", world.noise.level, {0, 10});
  noise.field("period", world.noise.period);
  reader.finish();
  return world;
}

TEST(ConfigDocument, AnEmptyFileKeepsEveryDefault) {
  const World world = read(ConfigDocument::fromString(""));
  EXPECT_EQ(world.type, "office");
  EXPECT_EQ(world.noise.period, 2);
  EXPECT_EQ(read(ConfigDocument::fromString("# only a comment\nnoise:\n")).noise.level, 1);
}

TEST(ConfigDocument, MissingFileIsNamed) {
  EXPECT_EQ(messageOf<InputError>([] { ConfigDocument::fromFile("/nowhere/world.yaml"); }),
            "/nowhere/world.yaml: cannot read: No such file or directory");
}

TEST(ConfigDocument, MalformedYamlIsNamedWithItsLine) {
  EXPECT_THAT(messageOf<InputError>(
                  [] { ConfigDocument::fromString("seed: 1\nrooms: [1, 2\n", "w.yaml"); }),
              HasSubstr("w.yaml:3: not valid YAML: "));
}

TEST(ConfigDocument, SomethingOtherThanAMapIsRefused) {
  EXPECT_EQ(messageOf<InputError>([] { ConfigDocument::fromString("- 1\n- 2\n", "w.yaml"); }),
            "w.yaml:1: expected keys with values (a map)");
  EXPECT_EQ(
      messageOf<InputError>([] { ConfigDocument::fromString("a: 1\n---\nb: 2\n", "w.yaml"); }),
      "w.yaml: holds 2 YAML documents, expected one");
}

TEST(ConfigDocument, AKeyGivenTwiceIsRefused) {
  EXPECT_EQ(messageOf<InputError>(
                [] { ConfigDocument::fromString("seed: 1\ntype: a\nseed: 2\n", "w.yaml"); }),
            "w.yaml:3: seed: given twice, first in line 1");
}

TEST(ConfigDocument, AliasesThatUnfoldWithoutEndAreRefused) {
  EXPECT_THAT(
      messageOf<InputError>([] { ConfigDocument::fromString("a: &x\n  b: *x\n", "w.yaml"); }),
      HasSubstr("w.yaml"));
  std::string bomb = "a0: &a0 [x, x, x, x, x, x, x, x, x, x]\n";
  for (int i = 1; i < 8; ++i) {
    bomb += "a" + std::to_string(i) + ": &a" + std::to_string(i) + " [";
    for (int k = 0; k < 10; ++k) bomb += (k ? ", *a" : "*a") + std::to_string(i - 1);
    bomb += "]\n";
  }
  EXPECT_EQ(messageOf<InputError>([&] { ConfigDocument::fromString(bomb, "w.yaml"); }),
            "w.yaml: nested too deeply or too large");
}

TEST(ConfigDocument, OverridesWinOverTheFile) {
  ConfigDocument document = ConfigDocument::fromString("seed: 1\nrooms: [4, 5]\n");
  document.set("seed=7");
  document.set("noise.level=2.5");
  document.set("rooms.1=9");
  document.set("type=a = b");
  const World world = read(document);
  EXPECT_EQ(world.seed, 7u);
  EXPECT_EQ(world.noise.level, 2.5);
  EXPECT_THAT(world.rooms, ::testing::ElementsAre(4, 9));
  EXPECT_EQ(world.type, "a = b");
  document.set("rooms=[]");
  EXPECT_TRUE(read(document).rooms.empty());
}

TEST(ConfigDocument, FaultsOfOverridesNameTheOverride) {
  ConfigDocument document = ConfigDocument::fromString("seed: 1\n", "w.yaml");
  document.set("noise.levl=2");
  document.set("noise.period=often");
  EXPECT_EQ(messageOf<InputError>([&] { read(document); }),
            "--set noise.levl: unknown key, did you mean noise.level?\n"
            "--set noise.period: expected a whole number of 32 bit, found 'often'");
}

TEST(ConfigDocument, OverridesThatCannotApplyAreRefused) {
  ConfigDocument document = ConfigDocument::fromString("seed: 1\nrooms: [4, 5]\n", "w.yaml");
  const auto refusal = [&](const std::string& assignment) {
    return messageOf<InputError>([&] { document.set(assignment); });
  };
  EXPECT_EQ(refusal("seed"), "--set seed: expected key=value, as in a.b=3");
  EXPECT_EQ(refusal("=3"), "--set =3: expected key=value, as in a.b=3");
  EXPECT_EQ(refusal("a..b=3"), "--set a..b=3: expected key=value, as in a.b=3");
  EXPECT_EQ(refusal("rooms.2=1"), "--set rooms.2=1: '2' is not an item of a list of 2");
  EXPECT_EQ(refusal("seed.x=1"), "--set seed.x=1: 'x' stands below the plain value '1' (w.yaml:1)");
  EXPECT_THAT(refusal("rooms=[1"), HasSubstr("--set rooms: not valid YAML"));
}

TEST(ConfigDocument, ABaseStandsUnderneathKeyByKey) {
  TemporaryFolder folder;
  writeText(folder / "common/root.yaml", "seed: 1\nrooms: [7]\nnoise:\n  level: 3\n  period: 4\n");
  writeText(folder / "common/middle.yaml", "base: root.yaml\nnoise:\n  level: 5\n");
  writeText(folder / "world.yaml", "base: common/middle.yaml\nseed: 9\nnoise:\n");
  const World world = read(ConfigDocument::fromFile(folder / "world.yaml"));
  EXPECT_EQ(world.seed, 9u);
  EXPECT_EQ(world.noise.level, 5);
  EXPECT_EQ(world.noise.period, 4);
  EXPECT_THAT(world.rooms, ::testing::ElementsAre(7));
}

TEST(ConfigDocument, ASectionOfAnotherTypeReplacesThatOfTheBaseWhole) {
  struct Tool {
    std::string type;
    std::string weights = "none";
    int width = 0;
  };
  const auto toolOf = [](const std::string& section) {
    TemporaryFolder folder;
    writeText(folder / "base.yaml", "seed: 3\ntool: {type: saw, weights: heavy, width: 7}\n");
    writeText(folder / "top.yaml", "base: base.yaml\ntool: " + section + "\n");
    ConfigReader reader(ConfigDocument::fromFile(folder / "top.yaml"));
    int seed = 0;
    reader.field("seed", seed);
    EXPECT_EQ(seed, 3);
    Tool tool;
    ConfigReader part = reader.section("tool");
    part.field("type", tool.type);
    part.field("weights", tool.weights);
    part.field("width", tool.width);
    reader.finish();
    return tool;
  };
  const Tool same = toolOf("{type: saw, width: 8}");
  EXPECT_EQ(same.weights, "heavy");
  EXPECT_EQ(same.width, 8);
  const Tool silent = toolOf("{width: 8}");
  EXPECT_EQ(silent.type, "saw");
  EXPECT_EQ(silent.weights, "heavy");
  const Tool other = toolOf("{type: drill, width: 8}");
  EXPECT_EQ(other.type, "drill");
  EXPECT_EQ(other.weights, "none");  // not those of a saw
  EXPECT_EQ(other.width, 8);
}

TEST(ConfigDocument, PathsAreRelativeToTheFileTheyStandIn) {
  TemporaryFolder folder;
  writeText(folder / "common/root.yaml", "mesh: chair.ply\n");
  writeText(folder / "world.yaml", "base: common/root.yaml\n");
  ConfigReader reader(ConfigDocument::fromFile(folder / "world.yaml"));
  std::filesystem::path mesh;
  reader.path("mesh", mesh);
  EXPECT_EQ(mesh, folder / "common/chair.ply");
}

TEST(ConfigDocument, FaultsInABaseNameTheBase) {
  TemporaryFolder folder;
  writeText(folder / "root.yaml", "\n\nsede: 1\n");
  writeText(folder / "world.yaml", "base: root.yaml\n");
  EXPECT_EQ(messageOf<InputError>([&] { read(ConfigDocument::fromFile(folder / "world.yaml")); }),
            (folder / "root.yaml").string() + ":3: sede: unknown key, did you mean seed?");
}

TEST(ConfigDocument, ABaseThatIsMissingOrCircularIsRefused) {
  TemporaryFolder folder;
  writeText(folder / "a.yaml", "seed: 1\nbase: b.yaml\n");
  EXPECT_EQ(messageOf<InputError>([&] { ConfigDocument::fromFile(folder / "a.yaml"); }),
            (folder / "a.yaml").string() + ":2: base: " + (folder / "b.yaml").string() +
                ": cannot read: No such file or directory");
  writeText(folder / "b.yaml", "base: a.yaml\n");
  EXPECT_THAT(messageOf<InputError>([&] { ConfigDocument::fromFile(folder / "a.yaml"); }),
              HasSubstr("b.yaml:1: base: " + (folder / "a.yaml").string() + " is based on itself"));
}

}  // namespace
}  // namespace hydrabench
