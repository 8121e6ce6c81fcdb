#include "app/contact_sheet.h"

#include <algorithm>
#include <cassert>
#include <cstdlib>
#include <numeric>

namespace enfilade {

namespace {

constexpr int kShownChannels = 3;

std::size_t pixelAt(const Image& image, int x, int y) {
  return 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
              static_cast<std::size_t>(x));
}

/// An opaque white picture.
Image blank(int width, int height) {
  Image image{width, height, {}};
  image.rgba.assign(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 255);
  return image;
}

void paste(const Image& image, int left, int top, Image& onto) {
  for (int y = 0; y < image.height; ++y) {
    std::copy_n(image.rgba.begin() + static_cast<std::ptrdiff_t>(pixelAt(image, 0, y)),
                4 * image.width,
                onto.rgba.begin() + static_cast<std::ptrdiff_t>(pixelAt(onto, left, top + y)));
  }
}

}  // namespace

std::vector<std::size_t> worstFrames(std::span<const double> values, std::size_t count,
                                     std::size_t apart) {
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });
  std::vector<std::size_t> worst;
  for (const std::size_t frame : order) {
    if (worst.size() == count) break;
    const bool near = std::any_of(worst.begin(), worst.end(), [&](std::size_t other) {
      return std::max(frame, other) - std::min(frame, other) < apart;
    });
    if (!near) worst.push_back(frame);
  }
  return worst;
}

Image arranged(const std::vector<std::vector<Image>>& rows) {
  if (rows.empty() || rows.front().empty()) return {};
  const int width = rows.front().front().width;
  const int height = rows.front().front().height;
  const auto across = static_cast<int>(rows.front().size());
  const auto down = static_cast<int>(rows.size());
  Image sheet =
      blank(across * (width + kSheetGap) - kSheetGap, down * (height + kSheetGap) - kSheetGap);
  int top = 0;
  for (const std::vector<Image>& row : rows) {
    int left = 0;
    for (const Image& image : row) {
      assert(image.width == width && image.height == height);
      paste(image, left, top, sheet);
      left += width + kSheetGap;
    }
    top += height + kSheetGap;
  }
  return sheet;
}

Image amplifiedDifference(const Image& a, const Image& b, int times) {
  assert(a.rgba.size() == b.rgba.size());
  Image difference = blank(a.width, a.height);
  for (std::size_t i = 0; i < a.rgba.size(); ++i) {
    if (i % 4 == 3) continue;
    difference.rgba[i] =
        static_cast<std::uint8_t>(std::min(times * std::abs(a.rgba[i] - b.rgba[i]), 255));
  }
  return difference;
}

Image shrunk(const Image& image, int by) {
  if (by <= 1) return image;
  Image small = blank(image.width / by, image.height / by);
  for (int y = 0; y < small.height; ++y) {
    for (int x = 0; x < small.width; ++x) {
      for (std::size_t c = 0; c < kShownChannels; ++c) {
        int sum = 0;
        for (int dy = 0; dy < by; ++dy) {
          for (int dx = 0; dx < by; ++dx) {
            sum += image.rgba[pixelAt(image, x * by + dx, y * by + dy) + c];
          }
        }
        small.rgba[pixelAt(small, x, y) + c] = static_cast<std::uint8_t>(sum / (by * by));
      }
    }
  }
  return small;
}

ContactSheet makeContactSheet(FramePainter& painter, const Walk& walk,
                              std::span<const Method> methods,
                              std::span<const std::size_t> frames) {
  ContactSheet sheet;
  sheet.methods.push_back(Method::kGeometry);
  for (const Method method : methods) sheet.methods.push_back(method);
  const int longest = std::max(painter.width(), painter.height());
  const int shrink = (longest + kSheetGreatestCell - 1) / kSheetGreatestCell;
  std::vector<std::vector<Image>> rows;
  for (const std::size_t frame : frames) {
    const Camera placed = walk.stepTo(frame, painter);
    ContactSheet::Row row{frame, {}};
    std::vector<Image> pictures;
    Image truth, picture;
    for (const Method method : sheet.methods) {
      painter.paint(method, placed);
      painter.read(picture);
      if (truth.rgba.empty()) truth = picture;
      row.psnr_db.push_back(psnr(picture, truth));
      pictures.push_back(shrunk(picture, shrink));
    }
    pictures.push_back(shrunk(amplifiedDifference(picture, truth, kSheetAmplification), shrink));
    rows.push_back(std::move(pictures));
    sheet.rows.push_back(std::move(row));
  }
  sheet.picture = arranged(rows);
  if (!rows.empty()) sheet.cell = {rows.front().front().width, rows.front().front().height};
  return sheet;
}

}  // namespace enfilade
