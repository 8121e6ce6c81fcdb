# cmake -DNAME=kThing -DINPUT=file -DHEADER=app/x.h -DOUTPUT=file.cpp -P EmbedFile.cmake
# Writes a source file that defines the string_view enfilade::NAME with the bytes of INPUT (none
# without one).
set(bytes "")
if(INPUT)
  file(SIZE "${INPUT}" size)
  set(offset 0)
  while(offset LESS size)  # a line a kilobyte
    file(READ "${INPUT}" hex OFFSET ${offset} LIMIT 1024 HEX)
    string(REGEX REPLACE "([0-9a-f][0-9a-f])" "'\\\\x\\1'," line "${hex}")
    string(APPEND bytes "${line}\n")
    math(EXPR offset "${offset} + 1024")
  endwhile()
endif()
file(WRITE "${OUTPUT}" "// Made by EmbedFile.cmake from ${INPUT}.
#include \"${HEADER}\"

namespace enfilade {
namespace {
constexpr char kBytes[] = {${bytes}'\\0'};
}
const std::string_view ${NAME}(kBytes, sizeof kBytes - 1);
}  // namespace enfilade
")
