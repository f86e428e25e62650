// A folder for one test.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace boxcar::test {

// A new, empty folder, removed with all that is in it when the test ends.
class TemporaryFolder {
public:
    TemporaryFolder();
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    const std::filesystem::path& Path() const { return m_path; }
    std::string Path(const std::string& name) const { return (m_path / name).string(); }

    // What is in it, sorted.
    std::vector<std::string> Names() const;

    // Write a file, make the folders that it is in, and return its path.
    std::string Put(const std::string& name, std::span<const uint8_t> bytes) const;
    std::string WriteText(const std::string& name, std::string_view text) const;

private:
    std::filesystem::path m_path;
};

// All bytes of a file. Fails the test if it cannot be read.
std::string ReadText(const std::filesystem::path& path);

}  // namespace boxcar::test
