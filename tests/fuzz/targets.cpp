#include "tests/fuzz/targets.h"

#include <algorithm>
#include <array>

namespace enfilade::fuzz {

std::string textOf(Bytes input) { return {input.begin(), input.end()}; }

Bytes takePart(Bytes& input) {
  const auto end = std::find(input.begin(), input.end(), std::uint8_t{0});
  const auto size = static_cast<std::size_t>(end - input.begin());
  const Bytes part = input.first(size);
  input = input.subspan(std::min(size + 1, input.size()));
  return part;
}

}  // namespace enfilade::fuzz
