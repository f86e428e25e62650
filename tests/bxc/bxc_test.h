// A folder of its own for each test, and the program bxc to run in it.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "tools/layout/shader_layout.h"

namespace boxcar {

struct RunResult {
    int exitCode = -1;
    std::string out;
    std::string err;
};

class BxcTest : public testing::Test {
protected:
    BxcTest();
    ~BxcTest() override;

    // Writes, reads, asks for a file in the test's folder. Read() of a file that is not there fails the test.
    void Write(const std::string& name, const std::string& text) const;
    std::string Read(const std::string& name) const;
    bool Exists(const std::string& name) const;
    ShaderLayout ReadLayout(const std::string& name) const;

    // Runs a program in the folder. Words are passed as they are; no shell reads them.
    RunResult RunProgram(const std::vector<std::string>& words) const;

    // The same for bxc.
    RunResult Bxc(std::vector<std::string> words) const;

    std::filesystem::path m_folder;
};

// A pixel shader that is accepted.
extern const char* const kPlainPixelShader;

}  // namespace boxcar
