#include "ibr/ldi_file.h"
#include "tests/fuzz/containers.h"
#include "tests/fuzz/soundness.h"

namespace enfilade::fuzz {

void ldi(Bytes input) {
  const Ldi image = decodeLdi(sealLdi(input), "ldi");
  std::size_t samples = 0;
  for (const LdiTile& tile : image.tiles) {
    require(tile.first == samples && tile.count > 0, "tiles one after another");
    require(tile.least_disparity <= tile.greatest_disparity, "a tile's bounds");
    samples += tile.count;
  }
  require(samples == image.samples.size(), "every sample in a tile");
  for (std::size_t c = 0; c < image.columns.size(); ++c) {
    for (const std::uint32_t tile : image.columnTiles(c)) {
      require(tile < image.tiles.size() && image.tiles[tile].x == c, "columns of tiles");
    }
  }
  require(image.row_tiles.back() == image.tiles.size(), "rows of tiles");
}

}  // namespace enfilade::fuzz
