#include "app/frame_record.h"

#include <array>

namespace enfilade {

namespace {

using Tail = FrameColumn::Tail;

std::optional<double> number(const std::optional<std::size_t>& count) {
  return count ? std::optional<double>(static_cast<double>(*count)) : std::nullopt;
}

using R = const FrameRecord&;
using V = std::optional<double>;

constexpr std::array<FrameColumn, 22> kColumns = {{
    {"frametime_ms", "frame_ms", 4, Tail::kHigh, [](R r) -> V { return r.cost.frametime_ms; }},
    {"cull_ms", "cull_ms", 4, Tail::kHigh, [](R r) -> V { return r.cost.cull_ms; }},
    {"warp_ms", "warp_ms", 4, Tail::kHigh, [](R r) -> V { return r.cost.warp_ms; }},
    {"composite_ms", "composite_ms", 4, Tail::kHigh, [](R r) -> V { return r.cost.composite_ms; }},
    {"draw_ms", "draw_ms", 4, Tail::kHigh, [](R r) -> V { return r.cost.draw_ms; }},
    {"triangles", "triangles", 0, Tail::kHigh, [](R r) { return number(r.cost.triangles); }},
    {"cells", "cells", 0, Tail::kHigh, [](R r) { return number(r.cost.cells); }},
    {"portals", "portals", 0, Tail::kHigh, [](R r) { return number(r.cost.portals); }},
    {"portals_as_images", "portals_as_images", 0, Tail::kHigh,
     [](R r) { return number(r.cost.portals_as_images); }},
    {"samples", "samples", 0, Tail::kHigh, [](R r) { return number(r.cost.samples); }},
    {"samples_clipped", "samples_clipped", 0, Tail::kHigh,
     [](R r) { return number(r.cost.samples_clipped); }},
    {"psnr_db", "psnr_db", 3, Tail::kLow,
     [](R r) -> V { return r.quality ? V(r.quality->psnr_db) : V(); }},
    {"ssim", "ssim", 6, Tail::kLow, [](R r) -> V { return r.quality ? V(r.quality->ssim) : V(); }},
    {"differing_percent", "differing_percent", 5, Tail::kHigh,
     [](R r) -> V { return r.quality ? V(r.quality->differing_percent) : V(); }},
    {"uncovered_percent", "uncovered_percent", 5, Tail::kHigh,
     [](R r) -> V { return r.cost.uncovered_percent; }},
    {"psnr_portals_db", "psnr_portals_db", 3, Tail::kLow,
     [](R r) -> V { return r.quality ? r.quality->psnr_portals_db : V(); }},
    {"ssim_portals", "ssim_portals", 6, Tail::kLow,
     [](R r) -> V { return r.quality ? r.quality->ssim_portals : V(); }},
    {"flicker", "flicker", 5, Tail::kHigh, [](R r) -> V { return r.flicker; }},
    {"capture_ms", "capture_ms", 4, Tail::kHigh, [](R r) -> V { return r.cost.capture_ms; }},
    {"load_ms", "load_ms", 4, Tail::kHigh, [](R r) -> V { return r.cost.load_ms; }},
    {"portals_lacking_image", "portals_lacking_image", 0, Tail::kHigh,
     [](R r) { return number(r.cost.portals_lacking_image); }},
    {"image_bytes", "image_bytes", 0, Tail::kHigh, [](R r) { return number(r.cost.image_bytes); }},
}};

}  // namespace

std::span<const FrameColumn> frameColumns() { return kColumns; }

}  // namespace enfilade
