// A folder of its own for each test, and the program bxc to run in it.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "tests/support/run_program.h"
#include "tests/support/temporary_folder.h"
#include "tools/layout/shader_layout.h"

namespace boxcar {

using test::RunResult;

class BxcTest : public testing::Test {
protected:
    // Writes, reads, asks for a file in the test's folder. Read() of a file that is not there fails the test.
    void Write(const std::string& name, const std::string& text) const;
    std::string Read(const std::string& name) const;
    bool Exists(const std::string& name) const;
    ShaderLayout ReadLayout(const std::string& name) const;

    // Runs a program in the folder. Words are passed as they are; no shell reads them.
    RunResult RunProgram(const std::vector<std::string>& words) const;

    // The same for bxc.
    RunResult Bxc(std::vector<std::string> words) const;

    const test::TemporaryFolder m_temporary;
    const std::filesystem::path m_folder = m_temporary.Path();
};

// A pixel shader that is accepted.
extern const char* const kPlainPixelShader;

}  // namespace boxcar
