// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/simulation/material.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace hydrabench {
namespace {

using Eigen::Vector3f;

std::array<float, 256> makeLinearTable() {
  std::array<float, 256> table{};
  for (int i = 0; i < 256; ++i) {
    const double c = i / 255.0;
    table[static_cast<std::size_t>(i)] =
        static_cast<float>(c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4));
  }
  return table;
}

constexpr int kSrgbSteps = 4096;

/// 8-bit sRGB at the middle of each step of linear light; finer than 8 bits need except in the
/// darkest few levels.
std::array<std::uint8_t, kSrgbSteps + 1> makeSrgbTable() {
  std::array<std::uint8_t, kSrgbSteps + 1> table{};
  for (int i = 0; i <= kSrgbSteps; ++i) {
    const double c = static_cast<double>(i) / kSrgbSteps;
    const double s = c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1 / 2.4) - 0.055;
    table[static_cast<std::size_t>(i)] = static_cast<std::uint8_t>(std::lround(255 * s));
  }
  return table;
}

std::uint32_t hashCell(std::int32_t x, std::int32_t y, std::int32_t z) {
  std::uint32_t h = static_cast<std::uint32_t>(x) * 0x9e3779b1u ^
                    static_cast<std::uint32_t>(y) * 0x85ebca77u ^
                    static_cast<std::uint32_t>(z) * 0xc2b2ae3du;
  h ^= h >> 15;
  h *= 0x2c1b3c6du;
  h ^= h >> 13;
  return h;
}

/// floor() for the coordinates that occur here; std::floor is a call without SSE 4.1.
std::int32_t floorToInt(float x) {
  const auto truncated = static_cast<std::int32_t>(x);
  return truncated - (static_cast<float>(truncated) > x ? 1 : 0);
}

float hashUnit(std::int32_t x, std::int32_t y, std::int32_t z) {
  return static_cast<float>(hashCell(x, y, z) >> 8) * 0x1.0p-24f;
}

float smoothStep(float low, float high, float x) {
  const float t = std::clamp((x - low) / (high - low), 0.0f, 1.0f);
  return t * t * (3 - 2 * t);
}

float fraction(float x) { return x - static_cast<float>(floorToInt(x)); }

/// The axis along which the normal points most.
std::int32_t mainAxis(const Vector3f& normal) {
  const Vector3f n = normal.cwiseAbs();
  if (n.z() >= n.x() && n.z() >= n.y()) return 2;
  return n.x() >= n.y() ? 0 : 1;
}

/// Coordinates within the surface: the other two axes.
Eigen::Vector2f surfaceCoordinates(const Vector3f& point, const Vector3f& normal) {
  switch (mainAxis(normal)) {
    case 0:
      return {point.y(), point.z()};
    case 1:
      return {point.x(), point.z()};
    default:
      return {point.x(), point.y()};
  }
}

/// Growth rings cut lengthwise: bands that run along the second coordinate, slightly bent, with
/// fine pores. The second coordinate is upright on upright faces and the width of tops, which is
/// how boards are cut.
float woodGrain(const Eigen::Vector2f& q, std::int32_t face_axis) {
  const float offset = 7.3f * static_cast<float>(face_axis);
  const float bend = valueNoise({0.9f * q.x(), 0.22f * q.y(), offset});
  const float ring = fraction(1.6f * q.x() + 2.2f * bend);
  const float pores = valueNoise({30 * q.x(), 1.4f * q.y(), offset});
  return 0.6f * smoothStep(0.0f, 0.85f, ring) * (1 - smoothStep(0.85f, 1.0f, ring)) + 0.4f * pores;
}

float weave(const Eigen::Vector2f& q) {
  const std::int32_t u = floorToInt(q.x());
  const std::int32_t v = floorToInt(q.y());
  const float across = ((u + v) & 1) != 0 ? fraction(q.x()) : fraction(q.y());
  const float thread = 4 * across * (1 - across);
  return 0.7f * thread + 0.3f * hashUnit(u, v, 7);
}

/// Windows with a title bar and lines of text, as on a switched-on screen.
float screenContent(const Eigen::Vector2f& q) {
  const Eigen::Vector2f cell(q.x() / 2.3f, q.y() / 1.7f);
  const std::int32_t u = floorToInt(cell.x());
  const std::int32_t v = floorToInt(cell.y());
  const float x = fraction(cell.x());
  const float y = fraction(cell.y());
  if (x < 0.04f || x > 0.96f || y < 0.04f || y > 0.96f) return 0.1f;
  if (y > 0.88f) return 0.75f;
  const std::int32_t line = floorToInt(14 * y);
  const float line_length = 0.25f + 0.65f * hashUnit(17 * u + line, v, 3);
  const bool text = fraction(14 * y) < 0.45f && x > 0.1f && x < line_length;
  return text ? 0.95f : 0.25f;
}

/// Share of the second colour.
float patternWeight(const Material& material, const Vector3f& point, const Vector3f& normal) {
  const Vector3f p = point / static_cast<float>(material.pattern_size_m);
  switch (material.pattern) {
    case Material::Pattern::kPlain:
      return 0;
    case Material::Pattern::kNoise:
      return 0.65f * valueNoise(p) + 0.35f * valueNoise(3.1f * p);
    case Material::Pattern::kWood:
      return woodGrain(surfaceCoordinates(p, normal), mainAxis(normal));
    case Material::Pattern::kStripes:
      return smoothStep(0.45f, 0.5f, std::abs(fraction(p.z()) - 0.5f) * 2);
    case Material::Pattern::kTiles: {
      const Eigen::Vector2f q = surfaceCoordinates(p, normal);
      const float u = fraction(q.x());
      const float v = fraction(q.y());
      const float edge = std::min({u, v, 1 - u, 1 - v});
      const float shade = 0.12f * hashUnit(floorToInt(q.x()), floorToInt(q.y()), 5);
      return edge < 0.02f ? 1.0f : shade;
    }
    case Material::Pattern::kLeaves:
      return 0.6f * valueNoise(p) + 0.4f * smoothStep(0.3f, 0.7f, valueNoise(5 * p));
    case Material::Pattern::kFabric:
      return 0.75f * weave(surfaceCoordinates(p, normal)) + 0.25f * valueNoise(0.12f * p);
    case Material::Pattern::kScreen:
      return screenContent(surfaceCoordinates(p, normal));
  }
  return 0;
}

}  // namespace

Vector3f linearFromSrgb(const Rgb& color) {
  static const std::array<float, 256> table = makeLinearTable();
  return {table[color.r], table[color.g], table[color.b]};
}

Rgb srgbFromLinear(const Vector3f& linear) {
  static const std::array<std::uint8_t, kSrgbSteps + 1> table = makeSrgbTable();
  const auto encode = [&](float c) {
    const float scaled = std::clamp(c, 0.0f, 1.0f) * kSrgbSteps + 0.5f;
    return table[static_cast<std::size_t>(scaled)];
  };
  return {encode(linear.x()), encode(linear.y()), encode(linear.z())};
}

float valueNoise(const Vector3f& p) {
  const std::int32_t x = floorToInt(p.x());
  const std::int32_t y = floorToInt(p.y());
  const std::int32_t z = floorToInt(p.z());
  const auto ease = [](float t) { return t * t * (3 - 2 * t); };
  const float u = ease(p.x() - static_cast<float>(x));
  const float v = ease(p.y() - static_cast<float>(y));
  const float w = ease(p.z() - static_cast<float>(z));
  const auto alongX = [&](std::int32_t j, std::int32_t k) {
    const float a = hashUnit(x, y + j, z + k);
    const float b = hashUnit(x + 1, y + j, z + k);
    return a + u * (b - a);
  };
  const float near = alongX(0, 0) + v * (alongX(1, 0) - alongX(0, 0));
  const float far = alongX(0, 1) + v * (alongX(1, 1) - alongX(0, 1));
  return near + w * (far - near);
}

Vector3f evaluate(const Material& material, const Vector3f& point, const Vector3f& normal) {
  const Vector3f first = linearFromSrgb(material.color);
  if (material.pattern == Material::Pattern::kPlain) return first;
  const float weight = std::clamp(patternWeight(material, point, normal), 0.0f, 1.0f);
  return first + weight * (linearFromSrgb(material.second_color) - first);
}

}  // namespace hydrabench
