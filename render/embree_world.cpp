#include "render/embree_world.h"

#include <embree3/rtcore.h>
#include <tbb/task_arena.h>

#include "scene/error.h"

namespace enfilade {

EmbreeWorld::EmbreeWorld() : device_(rtcNewDevice(nullptr)) {
  if (device_ == nullptr) throw Error(ErrorKind::kMachine, "Embree", "cannot be started");
  scene_ = rtcNewScene(device_);
  // Watertight: no ray slips through where two triangles meet.
  rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_ROBUST);
}

EmbreeWorld::~EmbreeWorld() {
  rtcReleaseScene(scene_);
  rtcReleaseDevice(device_);
}

RTCGeometryTy* EmbreeWorld::objectGeometry(const WorldGeometry& world, std::uint32_t object) const {
  const IndexRange& range = world.objects[object];
  RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
  rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                             world.vertices.data(), offsetof(WorldVertex, position),
                             sizeof(WorldVertex), world.vertices.size());
  rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                             world.indices.data(), range.first * sizeof(std::uint32_t),
                             3 * sizeof(std::uint32_t), range.count / 3);
  return geometry;
}

void EmbreeWorld::attach(RTCGeometryTy* geometry, std::uint32_t number) const {
  rtcCommitGeometry(geometry);
  rtcAttachGeometryByID(scene_, geometry, number);
  rtcReleaseGeometry(geometry);
}

void EmbreeWorld::commit() const {
  // On one thread, so that where surfaces coincide the same one is met in every run.
  tbb::task_arena(1).execute([&] { rtcJoinCommitScene(scene_); });
  if (rtcGetDeviceError(device_) != RTC_ERROR_NONE)
    throw Error(ErrorKind::kMachine, "Embree", "has no memory for the geometry");
}

}  // namespace enfilade
