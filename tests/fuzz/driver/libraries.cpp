// The libraries that read glTF, OBJ, PNG and JPEG for us, of the headers that Debian ships beside
// them: compiled here so that the fuzzer sees their branches and the address sanitizer their
// faults. What stands in an executable goes before what stands in a shared library.
#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define TINYGLTF_IMPLEMENTATION
#define TINYOBJLOADER_IMPLEMENTATION
#include <tiny_gltf.h>
#include <tiny_obj_loader.h>
