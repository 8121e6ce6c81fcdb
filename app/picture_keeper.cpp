#include "app/picture_keeper.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/contact_sheet.h"
#include "scene/file_io.h"

namespace enfilade {

PictureKeeper::PictureKeeper(std::string folder, std::size_t frames, std::size_t most)
    : folder_(std::move(folder)), stride_(most == 0 ? 0 : (frames + most - 1) / most) {}

void PictureKeeper::begin(std::span<const Method> methods) const {
  if (stride_ == 0) return;
  for (const Method method : methods) createFolders(folder_ + "/" + infoOf(method).name);
}

void PictureKeeper::keep(Method method, std::size_t frame, const Image& picture) const {
  writeFileAtomically(fmt::format("{}/{}/{:05}.jpg", folder_, infoOf(method).name, frame),
                      encodeJpeg(keptSize(picture), kKeptQuality));
}

Image keptSize(const Image& image) {
  const int by = (image.width + kKeptWidth - 1) / kKeptWidth;
  return shrunk(image, std::min(by, image.height));
}

}  // namespace enfilade
