// libFuzzer's entry: one program a target, whose name is ENFILADE_FUZZ_TARGET.
#include "scene/error.h"
#include "tests/fuzz/soundness.h"
#include "tests/fuzz/targets.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    enfilade::fuzz::ENFILADE_FUZZ_TARGET({data, size});
  } catch (const enfilade::Error& refused) {
    enfilade::fuzz::requireOneLine(refused.what());
  }
  return 0;
}
