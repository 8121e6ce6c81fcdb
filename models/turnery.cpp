// Things turned on a lathe: vases, columns, pedestals.
#include <algorithm>
#include <cmath>
#include <memory>

#include "models/noise.h"
#include "models/profile_curve.h"
#include "models/shapes.h"

namespace enfilade {
namespace {

constexpr double kTau = 6.283185307179586;

/// How the radius of a turned surface is carved: factor by angle, height share and arc share.
using Carving = std::function<double(double angle, double v)>;

glm::dvec3 aroundAxis(double radius, double y, double angle) {
  return {radius * std::cos(angle), y, -radius * std::sin(angle)};
}

/// A profile (radius, height), from low to high on the outside, turned around the y axis.
/// `carve` scales the radius; where it carves deep, shade gathers.
CurvedSurface turned(std::vector<glm::dvec2> points, const Carving& carve, double aspect) {
  const auto curve = std::make_shared<ProfileCurve>(points);
  CurvedSurface surface;
  surface.pole_low = points.front().x == 0;
  surface.pole_high = points.back().x == 0;
  surface.aspect = aspect;
  surface.at = [curve, carve](double u, double v) {
    const glm::dvec2 p = curve->at(v);
    const double scale = carve ? carve(kTau * u, v) : 1;
    return SurfacePoint{aroundAxis(p.x * scale, p.y, kTau * u),
                        std::clamp(1 - 2.2 * (1 - scale), 0.35, 1.0)};
  };
  return surface;
}

std::vector<glm::dvec2> vaseProfile(int style) {
  // Unit height, from the foot up the outside, over the lip and down inside.
  switch (style) {
    case 0:  // amphora
      return {{0.17, 0},    {0.17, 0},    {0.18, 0.03}, {0.09, 0.07}, {0.075, 0.1}, {0.2, 0.28},
              {0.3, 0.5},   {0.28, 0.66}, {0.14, 0.78}, {0.1, 0.88},  {0.15, 0.98}, {0.165, 1},
              {0.13, 0.99}, {0.08, 0.88}, {0.09, 0.8},  {0, 0.72}};
    case 1:  // krater
      return {{0.2, 0},     {0.2, 0},     {0.21, 0.05}, {0.1, 0.12}, {0.08, 0.2},
              {0.16, 0.28}, {0.3, 0.42},  {0.31, 0.6},  {0.32, 0.8}, {0.42, 0.95},
              {0.44, 1},    {0.41, 0.99}, {0.3, 0.82},  {0.28, 0.6}, {0, 0.5}};
    case 2:  // bottle
      return {{0.2, 0},     {0.2, 0},     {0.26, 0.12}, {0.29, 0.25}, {0.24, 0.4},  {0.1, 0.53},
              {0.065, 0.7}, {0.06, 0.88}, {0.09, 0.97}, {0.1, 1},     {0.07, 0.99}, {0, 0.8}};
    default:  // ginger jar, with its lid
      return {{0.15, 0},    {0.15, 0},   {0.16, 0.04}, {0.22, 0.2},   {0.3, 0.45},
              {0.3, 0.62},  {0.2, 0.75}, {0.13, 0.78}, {0.13, 0.78},  {0.17, 0.79},
              {0.17, 0.85}, {0.1, 0.92}, {0.03, 0.94}, {0.045, 0.98}, {0, 1}};
  }
}

Shape makeVase(const ShapeNumbers& n) {
  auto profile = vaseProfile(static_cast<int>(n.at("style")));
  for (glm::dvec2& p : profile) p *= glm::dvec2(n.at("height") * n.at("girth"), n.at("height"));
  const double flutes = n.at("flutes"), depth = n.at("depth"), twist = n.at("twist");
  const Carving carve = [=](double angle, double v) {
    // Flutes live on the belly and run out toward foot and lip.
    const double window = ramp(0.12, 0.3, v) * (1 - ramp(0.55, 0.72, v));
    return 1 - depth * window * (0.5 - 0.5 * std::cos(flutes * angle + twist * kTau * v));
  };
  return {{turned(profile, carve, 1.1)}, {}};
}

Shape makeTwistedColumn(const ShapeNumbers& n) {
  const double h = n.at("height"), r = n.at("radius"), strands = n.at("strands");
  const double depth = n.at("depth"), turns = n.at("turns");
  const std::vector<glm::dvec2> profile{
      {1.45 * r, 0},         {1.45 * r, 0},        {1.45 * r, 0.05 * h},
      {1.45 * r, 0.05 * h},  {1.5 * r, 0.06 * h},  {1.35 * r, 0.085 * h},
      {1.12 * r, 0.09 * h},  {1.12 * r, 0.1 * h},  {1.0 * r, 0.12 * h},
      {1.04 * r, 0.4 * h},   {0.95 * r, 0.75 * h}, {0.85 * r, 0.88 * h},
      {1.0 * r, 0.895 * h},  {0.9 * r, 0.91 * h},  {1.0 * r, 0.93 * h},
      {1.35 * r, 0.965 * h}, {1.5 * r, 0.972 * h}, {1.5 * r, 0.972 * h},
      {1.5 * r, h},          {1.5 * r, h},         {0, h}};
  const auto curve = std::make_shared<ProfileCurve>(profile);
  CurvedSurface shaft;
  shaft.pole_high = true;
  shaft.aspect = 0.55;
  shaft.repeats = {2, 2 * h / (kTau * r)};
  shaft.at = [=](double u, double v) {
    const glm::dvec2 p = curve->at(v);
    const double share = p.y / h;
    const double window = ramp(0.1, 0.2, share) * (1 - ramp(0.8, 0.9, share));
    const double wave = std::cos(strands * kTau * u - turns * kTau * share);
    const double groove = depth * window * (0.5 - 0.5 * wave);
    return SurfacePoint{
        aroundAxis(p.x * (1 - groove), p.y, kTau * u),
        (1 - 0.55 * window * (0.5 - 0.5 * wave)) * (0.7 + 0.3 * ramp(0, 0.2, share))};
  };
  return {{shaft}, {}};
}

Shape makeDrum(const ShapeNumbers& n) {
  const double h = n.at("height"), r = n.at("radius"), flutes = n.at("flutes");
  const std::vector<glm::dvec2> profile{{1.25 * r, 0},        {1.25 * r, 0},
                                        {1.25 * r, 0.08 * h}, {1.25 * r, 0.08 * h},
                                        {1.1 * r, 0.1 * h},   {1.0 * r, 0.14 * h},
                                        {0.95 * r, 0.5 * h},  {1.0 * r, 0.86 * h},
                                        {1.1 * r, 0.9 * h},   {1.2 * r, 0.93 * h},
                                        {1.2 * r, 0.93 * h},  {1.2 * r, h},
                                        {1.2 * r, h},         {0, h}};
  const Carving carve = [=](double angle, double v) {
    const double window = ramp(0.28, 0.32, v) * (1 - ramp(0.6, 0.64, v));
    return 1 - 0.06 * window * std::abs(std::sin(0.5 * flutes * angle));
  };
  CurvedSurface drum = turned(profile, carve, 1.6);
  const auto bare = drum.at;
  drum.at = [bare, h](double u, double v) {
    SurfacePoint p = bare(u, v);
    p.shade *= 0.6 + 0.4 * ramp(0, 0.45 * h, p.position.y);
    return p;
  };
  return {{drum}, {}};
}

Shape makePot(const ShapeNumbers& n) {
  const double h = n.at("height"), r = n.at("radius");
  return {{turned({{0.65 * r, 0},
                   {0.65 * r, 0},
                   {0.72 * r, 0.2 * h},
                   {0.88 * r, 0.75 * h},
                   {0.9 * r, 0.82 * h},
                   {0.9 * r, 0.82 * h},
                   {r, 0.83 * h},
                   {r, h},
                   {r, h},
                   {0.85 * r, h},
                   {0.85 * r, h},
                   {0.83 * r, 0.9 * h},
                   {0.83 * r, 0.9 * h},
                   {0, 0.88 * h}},
                  {}, 1.6)},
          {}};
}

}  // namespace

std::vector<ShapeKind> turneryKinds() {
  return {
      {"vase",
       4000,
       {{"height", 0.9, 0.05, 5},
        {"girth", 1, 0.2, 3},
        {"style", 0, 0, 3},
        {"flutes", 16, 0, 64},
        {"depth", 0.08, 0, 0.4},
        {"twist", 0, -8, 8}},
       makeVase},
      {"twisted-column",
       6000,
       {{"height", 2.6, 0.3, 10},
        {"radius", 0.16, 0.02, 2},
        {"strands", 3, 1, 12},
        {"depth", 0.35, 0, 0.7},
        {"turns", 3.5, -12, 12}},
       makeTwistedColumn},
      {"drum",
       1200,
       {{"height", 1, 0.1, 5}, {"radius", 0.3, 0.05, 3}, {"flutes", 20, 0, 64}},
       makeDrum},
      {"pot", 600, {{"height", 0.5, 0.05, 3}, {"radius", 0.3, 0.05, 3}}, makePot},
  };
}

}  // namespace enfilade
