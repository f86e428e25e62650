// Where the members of a constant block lie, in a compiled shader and in C++.
#pragma once

#include <cstddef>
#include <map>
#include <string>

#include "tools/layout/shader_layout.h"

namespace boxcar {

using Offsets = std::map<std::string, uint32_t>;

// The members that a shader uses: the optimizer may leave the rest out.
inline Offsets OffsetsIn(const EmbeddedShader& shader) {
    const ShaderLayout layout = ShaderLayoutFromJson(shader.layoutJson);
    Offsets offsets;
    for (const LayoutResource& resource : layout.resources)
        if (resource.kind == ResourceKind::PushConstants)
            for (const LayoutMember& member : resource.members)
                offsets[member.name] = member.offsetBytes;
    return offsets;
}

#define OFFSET(Struct, member) \
    { "g." #member, offsetof(Struct, member) }

}  // namespace boxcar
