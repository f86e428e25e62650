#include "tests/bxc/bxc_test.h"

namespace boxcar {

const char* const kPlainPixelShader = R"(
cbuffer Params : register(b0) { float4 tint; };
Texture2D<float4> source : register(t0);
SamplerState nearest : register(s0);
float4 main(float4 position : SV_Position, float2 uv : TEXCOORD0) : SV_Target0 {
    return source.Sample(nearest, uv) * tint;
}
)";

void BxcTest::Write(const std::string& name, const std::string& text) const {
    m_temporary.WriteText(name, text);
}

std::string BxcTest::Read(const std::string& name) const {
    return test::ReadText(m_folder / name);
}

bool BxcTest::Exists(const std::string& name) const {
    return std::filesystem::exists(m_folder / name);
}

ShaderLayout BxcTest::ReadLayout(const std::string& name) const {
    return ShaderLayoutFromJson(Read(name));
}

RunResult BxcTest::RunProgram(const std::vector<std::string>& words) const {
    return test::RunProgram(words, m_folder);
}

RunResult BxcTest::Bxc(std::vector<std::string> words) const {
    words.insert(words.begin(), BXC_PROGRAM);
    return RunProgram(words);
}

}  // namespace boxcar
