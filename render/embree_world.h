#pragma once

#include <cstdint>

#include "render/world_geometry.h"

struct RTCDeviceTy;
struct RTCSceneTy;
struct RTCGeometryTy;

namespace enfilade {

/// An Embree device with one scene, watertight where triangles meet: one geometry an object, whose
/// number is the object's.
class EmbreeWorld {
 public:
  /// Throws Error (kMachine).
  EmbreeWorld();
  ~EmbreeWorld();
  EmbreeWorld(const EmbreeWorld&) = delete;
  EmbreeWorld& operator=(const EmbreeWorld&) = delete;

  RTCDeviceTy* device() const noexcept { return device_; }
  RTCSceneTy* scene() const noexcept { return scene_; }

  /// The triangles of an object, not yet attached: filters may be set.  Shares the memory of
  /// `world`, which must outlive it.
  RTCGeometryTy* objectGeometry(const WorldGeometry& world, std::uint32_t object) const;
  /// Commits a geometry, gives it its number and lets go of it.
  void attach(RTCGeometryTy* geometry, std::uint32_t number) const;
  /// After all are attached, before the first ray.  Throws Error (kMachine).
  void commit() const;

 private:
  RTCDeviceTy* device_ = nullptr;
  RTCSceneTy* scene_ = nullptr;
};

}  // namespace enfilade
