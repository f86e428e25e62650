// boxcar_add_shaders (cmake/shaders.cmake), from a manifest to a program that holds the shaders.
#include <fmt/format.h>

#include "tests/bxc/bxc_test.h"

namespace boxcar {
namespace {

class AddShadersTest : public BxcTest {
protected:
    AddShadersTest() {
        Write("hlsl/shared.hlsli", "static const float kHalf = 0.5;\n");
        Write("hlsl/a.ps.hlsl", "#include \"shared.hlsli\"\nfloat4 main() : SV_Target0 { return kHalf * TAPS; }\n");
        Write("hlsl/b.ps.hlsl", kPlainPixelShader);
        Write("hlsl/s.cfg", "a.ps.hlsl -T ps -D TAPS={2,4}\nb.ps.hlsl -T ps\n");
        Write("main.cpp", R"(
#include "demo_shaders.h"
#include <cstdio>
#include <exception>
int main() {
    for (const boxcar::EmbeddedShader& shader : boxcar::demo_shaders::All())
        std::printf("%s %d\n", std::string(shader.name).c_str(), shader.spirv[0] == 0x07230203);
    const std::string json(boxcar::demo_shaders::Find("b.ps").layoutJson);
    std::printf("%s\n", boxcar::ShaderLayoutFromJson(json).source.c_str());
    try {
        boxcar::demo_shaders::Find("none");
    } catch (const std::exception& error) {
        std::printf("%s\n", error.what());
    }
}
)");
        Write("CMakeLists.txt", fmt::format(R"(
cmake_minimum_required(VERSION 3.25)
project(demo LANGUAGES CXX)
set(CMAKE_CXX_STANDARD 20)
find_package(fmt REQUIRED)
add_executable(bxc IMPORTED)
set_target_properties(bxc PROPERTIES IMPORTED_LOCATION {})
add_library(base STATIC IMPORTED)
set_target_properties(base PROPERTIES IMPORTED_LOCATION {})
add_library(layout STATIC IMPORTED)
set_target_properties(layout PROPERTIES IMPORTED_LOCATION {} INTERFACE_INCLUDE_DIRECTORIES {}
                      INTERFACE_LINK_LIBRARIES "base;fmt::fmt")
include({}/cmake/shaders.cmake)
add_executable(demo main.cpp)
boxcar_add_shaders(demo hlsl/s.cfg)
)",
                                            BXC_PROGRAM, BASE_LIBRARY, LAYOUT_LIBRARY, REPOSITORY, REPOSITORY));
    }

    std::string Make() {
        const RunResult run = RunProgram({CMAKE_PROGRAM, "--build", "build", "--target", "demo"});
        EXPECT_EQ(run.exitCode, 0) << run.out << run.err;
        return run.out;
    }
};

TEST_F(AddShadersTest, ProgramHoldsTheShadersAndAnIncludeRebuildsExactlyItsUsers) {
    const RunResult configured = RunProgram({CMAKE_PROGRAM, "-S", ".", "-B", "build", "-G", CMAKE_GENERATOR_NAME,
                                             fmt::format("-DCMAKE_CXX_COMPILER={}", CXX_COMPILER),
                                             fmt::format("-DCMAKE_CXX_FLAGS={}", CXX_FLAGS)});
    ASSERT_EQ(configured.exitCode, 0) << configured.out << configured.err;
    EXPECT_NE(Make().find("bxc: 3 shaders: 3 compiled\n"), std::string::npos);
    EXPECT_EQ(RunProgram({"build/demo"}).out,
              "a.ps.TAPS=2 1\na.ps.TAPS=4 1\nb.ps 1\nb.ps.hlsl\n"
              "demo_shaders: no shader is named 'none'; there are: a.ps.TAPS=2, a.ps.TAPS=4, b.ps\n");

    EXPECT_EQ(Make().find("bxc:"), std::string::npos) << "nothing has changed";
    Write("hlsl/shared.hlsli", "static const float kHalf = 0.25;\n");
    EXPECT_NE(Make().find("bxc: 3 shaders: 2 compiled, 1 up to date\n"), std::string::npos);
    Write("hlsl/s.cfg", "b.ps.hlsl -T ps\n");
    EXPECT_NE(Make().find("bxc: 1 shader: 1 up to date\n"), std::string::npos);
    EXPECT_EQ(RunProgram({"build/demo"}).out.substr(0, 7), "b.ps 1\n");
}

}  // namespace
}  // namespace boxcar
