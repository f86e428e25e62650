// The structs of hlsl/constants as C++ sees them; cmake/shared_structs.cmake writes the list.
#pragma once

#include <string>
#include <vector>

#include "tools/layout/shader_layout.h"

namespace boxcar {

struct SharedStruct {
    std::string name;
    size_t sizeBytes;
    std::vector<LayoutMember> members;
};

extern const std::vector<SharedStruct> kSharedStructs;

}  // namespace boxcar
