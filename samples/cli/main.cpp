// boxcar: filters pictures and draws the papers' effects with summed-area tables on a Vulkan device, headless.
//
//   boxcar filter | dof | resize | derive | sat | precision | render | sweep | inspect | list | fit-lobe | gallery |
//   devices
//
// Exit codes: 0; 1 the work failed, in one line; 2 the command line is wrong, in one line.
#include <fcntl.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <csignal>
#include <sstream>

#include "samples/cli/commands.h"
#include "samples/cli/console.h"
#include "tools/base/error.h"

namespace {

int Fail(int exitCode, std::string_view text) {
    boxcar::PrintProblem(text);
    return exitCode;
}

// A standard stream that the caller has closed would be the next file to be opened, which then gets what is meant for
// the stream. Here reading from it and writing to it fail.
void OccupyStandardDescriptors() {
    for (const int fd : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
        if (::fcntl(fd, F_GETFD) < 0) ::open("/dev/null", fd == STDIN_FILENO ? O_WRONLY : O_RDONLY);
}

void RequireCommand(const CLI::App& app, const std::string& word) {
    if (word.starts_with('-')) return;
    std::string commands;
    for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
        if (command->get_name() == word) return;
        commands += (commands.empty() ? "" : ", ") + command->get_name();
    }
    throw boxcar::UsageError("no command '{}'; there is {}", word, commands);
}

// Does what the command line says; the help and the version are documents like others.
void Run(CLI::App& app, const std::vector<boxcar::Command>& commands, int argc, char** argv) {
    try {
        app.parse(argc, argv);
    } catch (const CLI::Success& success) {
        std::ostringstream text;
        app.exit(success, text, text);
        boxcar::PrintDocument(text.str());
        return;
    }
    for (const boxcar::Command& command : commands)
        if (command.parser->parsed()) command.run();
}

}  // namespace

int main(int argc, char** argv) {
    OccupyStandardDescriptors();
    std::signal(SIGXFSZ, SIG_IGN);  // a limit of a file's size is then an error of write(2)
    CLI::App app("Filters pictures and draws effects with summed-area tables on a Vulkan device.", "boxcar");
    app.set_version_flag("--version", "boxcar " BOXCAR_VERSION);
    app.require_subcommand(1);
    app.footer("Example:\n  boxcar filter photo.jpg -o blurred.png --width 9\n\nboxcar COMMAND --help says more.");
    const std::vector<boxcar::Command> commands = {
        boxcar::AddFilterCommand(app),  boxcar::AddDofCommand(app),    boxcar::AddSatCommand(app),
        boxcar::AddResizeCommand(app),  boxcar::AddDeriveCommand(app), boxcar::AddPrecisionCommand(app),
        boxcar::AddGalleryCommand(app), boxcar::AddRenderCommand(app), boxcar::AddSweepCommand(app),
        boxcar::AddInspectCommand(app), boxcar::AddListCommand(app),   boxcar::AddFitLobeCommand(app),
        boxcar::AddDevicesCommand(app),
    };
    try {
        if (argc > 1) RequireCommand(app, argv[1]);
        Run(app, commands, argc, argv);
        return 0;
    } catch (const CLI::ParseError& error) {
        return Fail(2, error.what());
    } catch (const boxcar::UsageError& error) {
        return Fail(2, error.what());
    } catch (const std::bad_alloc&) {
        return Fail(1, "out of memory");
    } catch (const std::exception& error) {
        return Fail(1, error.what());
    }
}
