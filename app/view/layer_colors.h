#pragma once

#include <map>

#include "ibr/ldi.h"

namespace enfilade {

/// The same image with its samples in the colours of their layers: the nearest of a pixel green,
/// the second yellow, the third orange, those behind red; as bright as they were.
Ldi coloredByLayer(const Ldi& ldi);

/// Keeps what coloredByLayer() made, for an image that is asked for every frame.
class LayerColors {
 public:
  const Ldi* of(const Ldi& ldi);

 private:
  struct Entry {
    std::size_t samples = 0;  // of the image that it was made of: one made on demand grows
    Ldi colored;
  };
  std::map<const Ldi*, Entry> made_;
};

}  // namespace enfilade
