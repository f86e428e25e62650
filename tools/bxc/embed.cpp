#include "tools/bxc/embed.h"

#include <cstring>

#include "tools/base/read_file.h"
#include "tools/bxc/write.h"

namespace boxcar {
namespace {

constexpr const char* kHeader = R"(// Made by bxc.
#pragma once

#include "tools/layout/shader_layout.h"

#include <span>
#include <string_view>

namespace boxcar::{0} {{

// Every shader, in the order of the manifest.
std::span<const EmbeddedShader> All();

// The shader of this name, such as {1}. Throws Error naming those that there are.
const EmbeddedShader& Find(std::string_view name);

}}  // namespace boxcar::{0}
)";

constexpr const char* kSource = R"(// Made by bxc.
#include "{0}.h"

#include "tools/base/error.h"

#include <cstdint>

namespace boxcar::{0} {{
namespace {{

{1}const EmbeddedShader kShaders[] = {{
{2}}};

}}  // namespace

std::span<const EmbeddedShader> All() {{ return kShaders; }}

const EmbeddedShader& Find(std::string_view name) {{
    for (const EmbeddedShader& shader : kShaders)
        if (shader.name == name) return shader;
    std::string names;
    for (const EmbeddedShader& shader : kShaders) names.append(names.empty() ? "" : ", ").append(shader.name);
    throw Error("{0}: no shader is named '{{}}'; there are: {{}}", name, names);
}}

}}  // namespace boxcar::{0}
)";

// Text in C++, whatever bytes it has.
std::string Literal(std::string_view text) {
    std::string literal = "\"";
    for (const char c : text) {
        const bool isPlain = c >= ' ' && c <= '~' && c != '"' && c != '\\' && c != '?';
        literal += isPlain ? std::string(1, c) : fmt::format("\\{:03o}", static_cast<unsigned char>(c));
    }
    return literal + "\"";
}

}  // namespace

void WriteEmbedded(const std::vector<ShaderJob>& jobs, const std::string& dir, const std::string& name) {
    std::string words, table;
    for (size_t i = 0; i < jobs.size(); ++i) {
        const OutputFiles files = FilesOf(jobs[i]);
        const std::vector<uint8_t> bytes = ReadFile(files.spirv, {fmt::format("'{}'", files.spirv)});
        const std::vector<uint8_t> layout = ReadFile(files.layout, {fmt::format("'{}'", files.layout)});
        words += fmt::format("// {}\nconst uint32_t kSpirv{}[] = {{", Literal(jobs[i].options.output), i);
        for (size_t at = 0; at + sizeof(uint32_t) <= bytes.size(); at += sizeof(uint32_t)) {
            uint32_t word;
            std::memcpy(&word, &bytes[at], sizeof word);
            words += fmt::format("{}{:#x},", at % 32 == 0 ? "\n" : "", word);
        }
        words += fmt::format("\n}};\nconst char kLayout{}[] = R\"json({})json\";\n\n", i,
                             std::string_view(reinterpret_cast<const char*>(layout.data()), layout.size()));
        table += fmt::format("    {{{}, kSpirv{}, kLayout{}}},\n", Literal(jobs[i].options.output), i, i);
    }
    const std::string example = Literal(jobs.empty() ? "" : jobs[0].options.output);
    WriteFileIfChanged(dir + "/" + name + ".h", fmt::format(kHeader, name, example));
    WriteFileIfChanged(dir + "/" + name + ".cpp", fmt::format(kSource, name, words, table));
}

}  // namespace boxcar
