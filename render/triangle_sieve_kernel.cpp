// Compiled once for each kind of vector unit; the best that the machine has is chosen at run time.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/triangle_sieve_kernel.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h, as Highway asks.
#include <hwy/highway.h>

#include <limits>

#include "render/triangle_sieve_kernel.h"

HWY_BEFORE_NAMESPACE();
namespace enfilade {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using Lanes = hn::ScalableTag<float>;
using Floats = hn::Vec<Lanes>;
using Bools = hn::Mask<Lanes>;

/// A corner before the divide by w.
struct Corner {
  Floats x, y, w;
};

/// A triangle in the window, where every corner is before the eye.
struct OnScreen {
  Floats x[3], y[3];
  Floats slack;  // [pixels] that each coordinate may be off by
};

/// The centres that a triangle's box may hold: columns and rows, low > high where there are none.
struct Centers {
  Floats x0, y0, x1, y1;
};

HWY_INLINE Floats set(float value) { return hn::Set(Lanes(), value); }

HWY_INLINE Floats least(const Floats (&v)[3]) { return hn::Min(hn::Min(v[0], v[1]), v[2]); }
HWY_INLINE Floats most(const Floats (&v)[3]) { return hn::Max(hn::Max(v[0], v[1]), v[2]); }

HWY_INLINE Floats row(const glm::vec4& m, Floats x, Floats y, Floats z) {
  return hn::MulAdd(set(m.z), z, hn::MulAdd(set(m.y), y, hn::MulAdd(set(m.x), x, set(m.w))));
}

HWY_INLINE Corner corner(const SieveRows& rows, const float* const* p, std::size_t i) {
  const Floats x = hn::LoadU(Lanes(), p[0] + i);
  const Floats y = hn::LoadU(Lanes(), p[1] + i);
  const Floats z = hn::LoadU(Lanes(), p[2] + i);
  return {row(rows.x, x, y, z), row(rows.y, x, y, z), row(rows.w, x, y, z)};
}

/// Whether all corners are on the outer side of one edge of the window, or behind the eye.  Holds
/// for triangles that reach behind the eye, too.  An edge lies a pixel off the outermost centres.
HWY_INLINE Bools isOutside(const SieveRows& rows, const Corner (&c)[3]) {
  const Floats sure = set(-2 * rows.rounding);
  const Floats right = set(rows.last.x + 2);
  const Floats top = set(rows.last.y + 2);
  Floats left_of[3], right_of[3], below[3], above[3];
  for (int k = 0; k < 3; ++k) {
    left_of[k] = hn::Add(c[k].x, c[k].w);
    right_of[k] = hn::MulSub(right, c[k].w, c[k].x);
    below[k] = hn::Add(c[k].y, c[k].w);
    above[k] = hn::MulSub(top, c[k].w, c[k].y);
  }
  const Floats across = hn::Min(most(left_of), most(right_of));
  const Floats along = hn::Min(most(below), most(above));
  const Floats ahead = hn::Max(hn::Max(c[0].w, c[1].w), c[2].w);
  return hn::Lt(hn::Min(hn::Min(across, along), ahead), sure);
}

HWY_INLINE OnScreen project(const SieveRows& rows, const Corner (&c)[3], Floats least_w) {
  OnScreen t;
  for (int k = 0; k < 3; ++k) {
    const Floats inverse = hn::Div(set(1), c[k].w);
    t.x[k] = hn::Mul(c[k].x, inverse);
    t.y[k] = hn::Mul(c[k].y, inverse);
  }
  const Floats reach = hn::Max(hn::Max(hn::Abs(least(t.x)), hn::Abs(most(t.x))),
                               hn::Max(hn::Abs(least(t.y)), hn::Abs(most(t.y))));
  // An error of w moves a corner by as much more as it is farther off than the window is wide.
  const Floats windows = hn::MulAdd(reach, set(1 / (rows.last.x + rows.last.y + 2)), set(1));
  t.slack = hn::MulAdd(hn::Div(set(rows.rounding), least_w), windows,
                       hn::MulAdd(reach, set(1e-6f), set(rows.snapping)));
  return t;
}

HWY_INLINE Centers centersIn(const SieveRows& rows, const OnScreen& t) {
  const Floats half = set(0.5f);
  const Floats grown = hn::Sub(t.slack, half);
  const Floats shrunk = hn::Add(t.slack, half);
  return {hn::Max(hn::Ceil(hn::Sub(least(t.x), shrunk)), set(0)),
          hn::Max(hn::Ceil(hn::Sub(least(t.y), shrunk)), set(0)),
          hn::Min(hn::Floor(hn::Add(most(t.x), grown)), set(rows.last.x)),
          hn::Min(hn::Floor(hn::Add(most(t.y), grown)), set(rows.last.y))};
}

/// By how much the double area of the triangle (a, b: two of its edges, or an edge and a point)
/// may be off when each coordinate may be by `slack`.
HWY_INLINE Floats areaError(Floats ax, Floats ay, Floats bx, Floats by, Floats slack) {
  const Floats lengths =
      hn::Add(hn::Add(hn::Abs(ax), hn::Abs(ay)), hn::Add(hn::Abs(bx), hn::Abs(by)));
  return hn::Mul(hn::Add(slack, slack), hn::MulAdd(set(4), slack, lengths));
}

/// How a triangle is wound in the window, if rounding cannot have turned it.
struct Winding {
  Floats area;  // twice the area, positive where it is counter-clockwise
  Bools sure;
};

HWY_INLINE Winding windingOf(const OnScreen& t) {
  const Floats ax = hn::Sub(t.x[1], t.x[0]), ay = hn::Sub(t.y[1], t.y[0]);
  const Floats bx = hn::Sub(t.x[2], t.x[0]), by = hn::Sub(t.y[2], t.y[0]);
  const Floats area = hn::NegMulAdd(ay, bx, hn::Mul(ax, by));
  return {area, hn::Gt(hn::Abs(area), areaError(ax, ay, bx, by, t.slack))};
}

/// Whether a triangle that is wound for sure misses the centre of (x0, y0).
HWY_INLINE Bools misses(const OnScreen& t, const Centers& at, Floats area) {
  const Floats sign = hn::CopySign(set(1), area);
  const Floats px = hn::Add(at.x0, set(0.5f));
  const Floats py = hn::Add(at.y0, set(0.5f));
  Bools outside = hn::FirstN(Lanes(), 0);
  for (int k = 0; k < 3; ++k) {
    const int next = (k + 1) % 3;
    const Floats ax = hn::Sub(t.x[next], t.x[k]), ay = hn::Sub(t.y[next], t.y[k]);
    const Floats bx = hn::Sub(px, t.x[k]), by = hn::Sub(py, t.y[k]);
    const Floats side = hn::Mul(sign, hn::NegMulAdd(ay, bx, hn::Mul(ax, by)));
    outside = hn::Or(outside, hn::Lt(side, hn::Neg(areaError(ax, ay, bx, by, t.slack))));
  }
  return outside;
}

/// Whether it covers no centre or shows its back.
HWY_INLINE Bools isHollow(const SieveRows& rows, const OnScreen& t, const Centers& c,
                          const Winding& winding) {
  const Bools none = hn::Or(hn::Lt(c.x1, c.x0), hn::Lt(c.y1, c.y0));
  const Bools one = hn::And(hn::Eq(c.x0, c.x1), hn::Eq(c.y0, c.y1));
  Bools shows_nothing = hn::And(one, misses(t, c, winding.area));
  if (rows.drops_counter) {
    shows_nothing = hn::Or(shows_nothing, hn::Gt(winding.area, set(0)));
  }
  return hn::Or(none, hn::And(winding.sure, shows_nothing));
}

/// The greatest 1 / w that a rasteriser may give it.  Corners that are moved draw a surface beyond
/// its own corners by as much as it is thin: a quarter of its range if it is wound for sure.
HWY_INLINE Floats nearestOf(const Corner (&c)[3], Floats least_w, Bools told,
                            const Winding& winding) {
  const Floats most_w = hn::Max(hn::Max(c[0].w, c[1].w), c[2].w);
  const Floats nearest = hn::Div(set(1), least_w);
  const Floats range = hn::Sub(nearest, hn::Div(set(1), most_w));
  const Floats unknown = set(std::numeric_limits<float>::infinity());
  return hn::IfThenElse(hn::And(told, winding.sure), hn::MulAdd(range, set(0.5f), nearest),
                        unknown);
}

struct Sieve {
  const SieveRows& rows;
  const SieveOutput& out;
  std::size_t kept = 0;

  HWY_INLINE void store(Floats value, Bools keep, std::int32_t* to) {
    const hn::RebindToSigned<Lanes> whole;
    hn::CompressStore(hn::ConvertTo(whole, value), hn::RebindMask(whole, keep), whole, to + kept);
  }

  /// The triangles from `i` on, as many as there are lanes; `count` of them are asked for.
  HWY_INLINE void sift(const TriangleCorners& p, std::size_t i, std::size_t count) {
    const Lanes d;
    const Corner c[3] = {corner(rows, &p[0], i), corner(rows, &p[3], i), corner(rows, &p[6], i)};
    const Floats least_w = hn::Min(hn::Min(c[0].w, c[1].w), c[2].w);
    // Nearer to the eye's plane the divide tells nothing.
    const Bools told = hn::Gt(least_w, set(8 * rows.rounding));
    const OnScreen t = project(rows, c, least_w);
    const Centers centers = centersIn(rows, t);
    const Winding winding = windingOf(t);
    const Bools hollow = isHollow(rows, t, centers, winding);
    Bools keep = hn::AndNot(hn::And(told, hollow), hn::FirstN(d, count));
    keep = hn::AndNot(isOutside(rows, c), keep);
    const hn::RebindToUnsigned<Lanes> whole;
    hn::CompressStore(hn::Iota(whole, static_cast<std::uint32_t>(i)), hn::RebindMask(whole, keep),
                      whole, out.triangle + kept);
    store(hn::IfThenElseZero(told, centers.x0), keep, out.x0);
    store(hn::IfThenElseZero(told, centers.y0), keep, out.y0);
    store(hn::IfThenElse(told, centers.x1, set(rows.last.x)), keep, out.x1);
    store(hn::IfThenElse(told, centers.y1, set(rows.last.y)), keep, out.y1);
    const Floats nearest = nearestOf(c, least_w, told, winding);
    kept += hn::CompressStore(nearest, keep, d, out.nearest + kept);
  }
};

std::size_t Sift(const TriangleCorners& corners, std::size_t first, std::size_t count,
                 const SieveRows& rows, const SieveOutput& out) {
  Sieve sieve{rows, out};
  const std::size_t step = hn::Lanes(Lanes());
  for (std::size_t i = 0; i < count; i += step) sieve.sift(corners, first + i, count - i);
  return sieve.kept;
}

}  // namespace HWY_NAMESPACE
}  // namespace enfilade
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace enfilade {

HWY_EXPORT(Sift);

std::size_t siftTriangles(const TriangleCorners& corners, std::size_t first, std::size_t count,
                          const SieveRows& rows, const SieveOutput& out) noexcept {
  return HWY_DYNAMIC_DISPATCH(Sift)(corners, first, count, rows, out);
}

}  // namespace enfilade
#endif
