// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/config/config_reader.h"

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/types/error.h"
#include "tests/support/temporary_folder.h"

namespace hydrabench {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

/// The fault that reading `yaml` with `declare` gives.
template <typename Declare>
std::string faults(const std::string& yaml, const Declare& declare) {
  ConfigReader reader(ConfigDocument::fromString(yaml, "w.yaml"));
  declare(reader);
  return messageOf<InputError>([&] { reader.finish(); });
}

TEST(ConfigReader, ReadsEveryType) {
  ConfigReader reader(ConfigDocument::fromString(R"(
flag: true
small: -3
large: -9007199254740993
seed: 18446744073709551615
ratio: 0.1
exact: 1.0e-7
name: 007
quoted: "5"
weights: [1, 2.5]
counts: []
words: [a, b c]
kind: lidar
)"));
  bool flag = false;
  int small = 0;
  std::int64_t large = 0;
  std::uint64_t seed = 0;
  float ratio = 0;
  double exact = 0;
  std::string name, quoted, kind = "camera";
  std::vector<double> weights;
  std::vector<int> counts{1};
  std::vector<std::string> words;
  reader.field("flag", flag);
  reader.field("small", small);
  reader.field("large", large);
  reader.field("seed", seed);
  reader.field("ratio", ratio);
  reader.field("exact", exact);
  reader.field("name", name);
  reader.field("quoted", quoted);
  reader.field("weights", weights);
  reader.field("counts", counts);
  reader.field("words", words);
  reader.choice("kind", kind, {"camera", "lidar"});
  EXPECT_NO_THROW(reader.finish());
  EXPECT_TRUE(flag);
  EXPECT_EQ(small, -3);
  EXPECT_EQ(large, -9007199254740993);  // has no double
  EXPECT_EQ(seed, 18446744073709551615u);
  EXPECT_EQ(ratio, 0.1f);
  EXPECT_EQ(exact, 1e-7);
  EXPECT_EQ(name, "007");
  EXPECT_EQ(quoted, "5");
  EXPECT_THAT(weights, ElementsAre(1, 2.5));
  EXPECT_THAT(counts, IsEmpty());
  EXPECT_THAT(words, ElementsAre("a", "b c"));
  EXPECT_EQ(kind, "lidar");
}

TEST(ConfigReader, AllFaultsComeInOneMessageInTheOrderOfTheFile) {
  const std::string message = faults(
      "rate_hz: fast\n"
      "range_m: 200\n"
      "sead: 3\n"
      "noise:\n"
      "  levle: 1\n"
      "kind: sonar\n"
      "list: 3\n",
      [](ConfigReader& reader) {
        double rate = 1, range = 1, level = 1;
        int seed = 0;
        std::string kind = "camera";
        std::vector<int> list;
        reader.field("list", list);
        reader.field("rate_hz", rate);
        reader.field("range_m", range, {0, 100});
        reader.field("seed", seed);
        reader.section("noise").field("level", level);
        reader.choice("kind", kind, {"camera", "lidar"});
        reader.require("name");
      });
  EXPECT_EQ(message,
            "w.yaml: name: missing, must be given\n"
            "w.yaml:1: rate_hz: expected a finite number, found 'fast'\n"
            "w.yaml:2: range_m: 200 is out of bounds, expected 0 to 100\n"
            "w.yaml:3: sead: unknown key, did you mean seed?\n"
            "w.yaml:5: noise.levle: unknown key, did you mean noise.level?\n"
            "w.yaml:6: kind: 'sonar' is unknown, expected one of: camera, lidar\n"
            "w.yaml:7: list: expected a list as in [a, b], found '3'");
}

TEST(ConfigReader, WrongTypesAreNotBentIntoShape) {
  const auto asInt = [](ConfigReader& reader) {
    int value = 0;
    reader.field("x", value);
  };
  const auto asDouble = [](ConfigReader& reader) {
    double value = 0;
    reader.field("x", value);
  };
  const auto asSeed = [](ConfigReader& reader) {
    std::uint64_t value = 0;
    reader.field("x", value);
  };
  const auto asBool = [](ConfigReader& reader) {
    bool value = false;
    reader.field("x", value);
  };
  EXPECT_EQ(faults("x: 1.5", asInt), "w.yaml:1: x: expected a whole number of 32 bit, found '1.5'");
  EXPECT_EQ(faults("x: 3000000000", asInt),
            "w.yaml:1: x: expected a whole number of 32 bit, found '3000000000'");
  EXPECT_EQ(faults("x: \"5\"", asInt),
            "w.yaml:1: x: expected a whole number of 32 bit, found \"5\"");
  EXPECT_EQ(faults("x: 5 m", asDouble), "w.yaml:1: x: expected a finite number, found '5 m'");
  EXPECT_EQ(faults("x: .nan", asDouble), "w.yaml:1: x: expected a finite number, found '.nan'");
  EXPECT_EQ(faults("x: inf", asDouble), "w.yaml:1: x: expected a finite number, found 'inf'");
  EXPECT_EQ(faults("x: 1e999", asDouble), "w.yaml:1: x: expected a finite number, found '1e999'");
  EXPECT_EQ(faults("x: -1", asSeed), "w.yaml:1: x: expected a whole number from 0 on, found '-1'");
  EXPECT_EQ(faults("x: 1", asBool), "w.yaml:1: x: expected true or false, found '1'");
  EXPECT_EQ(faults("x: [1]", asBool), "w.yaml:1: x: expected true or false, found a list");
  EXPECT_EQ(faults("x: {a: 1}", asInt),
            "w.yaml:1: x: expected a whole number of 32 bit, found a map");
  EXPECT_EQ(faults("x:", asInt), "w.yaml:1: x: expected a whole number of 32 bit, found nothing");
}

TEST(ConfigReader, AFaultyValueLeavesTheDefault) {
  ConfigReader reader(ConfigDocument::fromString("x: 50\nk: z"));
  double x = 3;
  std::string k = "a";
  reader.field("x", x, {0, 10});
  reader.choice("k", k, {"a", "b"});
  EXPECT_EQ(x, 3);
  EXPECT_EQ(k, "a");
  EXPECT_THROW(reader.finish(), InputError);
}

TEST(ConfigReader, BoundsAreInclusiveAndMayBeOneSided) {
  const auto atLeast = [](ConfigReader& reader) {
    double value = 0;
    reader.field("x", value, {.low = 0.5});
  };
  EXPECT_EQ(faults("x: 0.4", atLeast), "w.yaml:1: x: 0.4 is out of bounds, expected at least 0.5");
  const auto atMost = [](ConfigReader& reader) {
    std::vector<int> value;
    reader.field("x", value, {.high = 2});
  };
  EXPECT_EQ(faults("x: [1, 2, 3]", atMost),
            "w.yaml:1: x.2: 3 is out of bounds, expected at most 2");
  ConfigReader reader(ConfigDocument::fromString("x: 0.5"));
  atLeast(reader);
  EXPECT_NO_THROW(reader.finish());
}

TEST(ConfigReader, AKeyAtTheWrongLevelIsPointedToItsPlace) {
  const std::string message = faults("dropout: 1", [](ConfigReader& reader) {
    double value = 0;
    reader.section("sensor").section("noise").field("dropout", value);
  });
  EXPECT_EQ(message, "w.yaml:1: dropout: unknown key, did you mean sensor.noise.dropout?");
}

TEST(ConfigReader, AnUnknownKeyWithoutANeighbourListsWhatIsKnown) {
  const std::string message = faults("zzz: 1", [](ConfigReader& reader) {
    int value = 0;
    reader.field("seed", value);
    reader.field("rate_hz", value);
  });
  EXPECT_EQ(message, "w.yaml:1: zzz: unknown key, expected one of: seed, rate_hz");
}

TEST(ConfigReader, ListsOfMapsAreReadItemByItem) {
  const std::string yaml = "rooms:\n- name: a\n  area: 3\n- name: b\n  aria: 4\n- 5\n";
  std::vector<std::string> names;
  const std::string message = faults(yaml, [&](ConfigReader& reader) {
    for (ConfigReader& room : reader.list("rooms")) {
      double area = 1;
      room.field("name", names.emplace_back());
      room.field("area", area);
    }
  });
  EXPECT_THAT(names, ElementsAre("a", "b"));
  EXPECT_EQ(message,
            "w.yaml:5: rooms.1.aria: unknown key, did you mean rooms.1.area?\n"
            "w.yaml:6: rooms.2: expected keys with values (a map), found '5'");
}

TEST(ConfigReader, CallersMayAddFaults) {
  const std::string message = faults("near_m: 3\nfar_m: 2\n", [](ConfigReader& reader) {
    double value = 0;
    reader.field("near_m", value);
    reader.field("far_m", value);
    reader.fault("far_m", "2 is below near_m");
  });
  EXPECT_EQ(message, "w.yaml:2: far_m: 2 is below near_m");
}

TEST(ConfigReader, ResolvedHoldsEveryKeyInOrderOfDeclarationAndReadsBack) {
  const auto declare = [](ConfigReader& reader, double third) {
    std::string name = "true", empty;
    std::vector<std::string> words{"a", "b: c", "1"};
    std::vector<double> numbers{third, 1e-7};
    int depth = 4;
    double level = third;
    float ratio = 0.1f;
    bool on = true;
    reader.field("name", name);
    ConfigReader noise = reader.section("noise");
    noise.field("level", level);
    noise.section("deep").field("depth", depth);
    reader.field("words", words);
    reader.field("numbers", numbers);
    reader.field("ratio", ratio);
    reader.field("flag", on);
    reader.field("empty", empty);
    for (ConfigReader& item : reader.list("items")) {
      int a = 0, b = 2;
      item.field("a", a);
      item.field("b", b);
    }
    reader.finish();
    return reader.resolved();
  };
  ConfigReader reader(ConfigDocument::fromString("items: [{a: 1}, {a: 5, b: 6}]"));
  const std::string yaml = declare(reader, 1.0 / 3.0);
  EXPECT_EQ(yaml,
            "name: \"true\"\n"
            "noise:\n"
            "  level: 0.3333333333333333\n"
            "  deep:\n"
            "    depth: 4\n"
            "words: [a, \"b: c\", \"1\"]\n"
            "numbers: [0.3333333333333333, 1e-07]\n"
            "ratio: 0.1\n"
            "flag: true\n"
            "empty: \"\"\n"
            "items:\n"
            "  - a: 1\n"
            "    b: 2\n"
            "  - a: 5\n"
            "    b: 6\n");
  ConfigReader again(ConfigDocument::fromString(yaml));
  EXPECT_EQ(declare(again, 0), yaml);
}

}  // namespace
}  // namespace hydrabench
