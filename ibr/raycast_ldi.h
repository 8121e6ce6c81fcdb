#pragma once

#include "ibr/portal_capture.h"
#include "render/ray_caster.h"

namespace enfilade {

/// The layered depth image of a portal's side by casting rays instead of warping captures: every
/// surface along each ray of the central view, beyond the portal's plane, that some viewpoint of
/// captureViewpoints() sees through the portal (and its margin), coloured as a capture from there
/// shows it: from the central viewpoint if it is seen from there, otherwise from the one whose
/// pixel covers the least of the surface.  `rays` × `rays` rays a pixel, averaged within a surface.
/// Where nothing is met, the sky.  The window grows outward, tile by tile, as long as something is
/// seen there, to `ldi_half_width` at most.
///
/// What is seen through blended material is tinted by it, once and for all, as in a capture;
/// blended material itself is no sample.  A surface that the central rays graze has few samples,
/// however well another viewpoint sees it: captures serve better there.
///
/// `objects` as for bakeLdi().  `caster` must show the same building, doors hidden.  Uses all
/// threads that TBB may; the same bytes for any number of them.
/// Source: Rafferty et al. 1998, sec. 3.2, Figure 4a.
Ldi raycastLdi(const RayCaster& caster, const Portal& portal, bool from_front, float eye_y,
               const ImageParameters& parameters, const ObjectsInView& objects, double far_depth);

}  // namespace enfilade
