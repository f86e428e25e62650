#include "runtime/mesh.h"

#include <algorithm>
#include <cstring>

#include "runtime/vulkan.h"
#include "tools/base/error.h"

namespace boxcar {
namespace {

void Check(std::span<const Vertex> vertices, std::span<const uint32_t> indices, const std::string& name) {
    if (indices.empty() || indices.size() % 3 != 0 || indices.size() > UINT32_MAX)
        throw Error("mesh '{}' has {} indices: three a triangle, of 1 to {} triangles, are expected", name,
                    indices.size(), UINT32_MAX / 3);
    const auto wrong = std::ranges::find_if(indices, [&](uint32_t index) { return index >= vertices.size(); });
    if (wrong != indices.end())
        throw Error("mesh '{}' has the index {}, but {} vertices", name, *wrong, vertices.size());
}

}  // namespace

Mesh::Mesh(Device& device, std::span<const Vertex> vertices, std::span<const uint32_t> indices,
           const std::string& name) {
    Check(vertices, indices, name);
    using Usage = vk::BufferUsageFlagBits;
    using Property = vk::MemoryPropertyFlagBits;
    using Stage = vk::PipelineStageFlagBits2;
    using Access = vk::AccessFlagBits2;
    Device::Impl& d = device.impl();
    const uint64_t bytes = vertices.size_bytes() + indices.size_bytes();
    m_impl.reset(new Impl{{d, bytes, Usage::eVertexBuffer | Usage::eIndexBuffer | Usage::eTransferDst,
                           Property::eDeviceLocal, fmt::format("mesh '{}'", name)},
                          vertices.size_bytes(),
                          static_cast<uint32_t>(indices.size())});

    const Buffer staging(d, bytes, Usage::eTransferSrc, Property::eHostVisible | Property::eHostCoherent,
                         fmt::format("staging of mesh '{}'", name));
    std::memcpy(staging.Mapped(), vertices.data(), vertices.size_bytes());
    std::memcpy(staging.Mapped() + vertices.size_bytes(), indices.data(), indices.size_bytes());
    CommandList commands(device);
    commands.impl().own.copyBuffer(staging.Handle(), m_impl->buffer.Handle(), vk::BufferCopy(0, 0, bytes));
    // Covers every draw to come: nothing writes the buffer again.
    const vk::MemoryBarrier2 toDraws(Stage::eTransfer, Access::eTransferWrite, Stage::eVertexInput,
                                     Access::eVertexAttributeRead | Access::eIndexRead);
    commands.impl().own.pipelineBarrier2(vk::DependencyInfo({}, toDraws));
    commands.SubmitAndWait();
}

Mesh::~Mesh() = default;
Mesh::Mesh(Mesh&&) noexcept = default;
Mesh& Mesh::operator=(Mesh&&) noexcept = default;

}  // namespace boxcar
