#include "mine/compile/kit_build.h"

#include <filesystem>
#include <system_error>

#include <fmt/format.h>

#include "base/error.h"
#include "base/files.h"
#include "base/quoted.h"
#include "mine/compile/compile_messages.h"
#include "mine/compile/compiler_run.h"
#include "mine/compile/fingerprint.h"
#include "mine/compile/kit_files.h"

namespace rasterwalk {

namespace {

namespace fs = std::filesystem;

/// All that a precompiled header depends on. The system's headers are not asked one by one: those
/// of GLM and of the compiler change with an update of the system.
std::string ready_name(const Compiler& compiler, const std::vector<std::string>& flags) {
    Fingerprint fingerprint;
    fingerprint.add(compiler.path).add(compiler.version).add(kit_version());
    for (const std::string& flag : flags)
        fingerprint.add(flag);
    for (const std::string& path : {compiler.path, std::string("/usr/include/glm/glm.hpp"),
                                    std::string("/usr/include/stdio.h")}) {
        const FileState state = file_state(path);
        fingerprint.add(fmt::format("{} {}", state.written.time_since_epoch().count(), state.size));
    }
    return "ready-" + fingerprint.text();
}

[[noreturn]] void refuse(const Compiler& compiler, const GuardedRun& run) {
    if (run.output.find("glm/glm.hpp") != std::string::npos) {
        throw AccessError("There is no GLM, the library for vectors: install it (on Debian and "
                          "Ubuntu: apt install libglm-dev).");
    }
    const std::vector<SaidMessage> said = read_compile_messages(run.output);
    const std::string first = said.empty() ? run.output.substr(0, 200) : said.front().message.text;
    throw AccessError(fmt::format("{} cannot compile what comes with Rasterwalk: {}.",
                                  compiler.version, visible_line(first)));
}

/// Compiles a file of the kit, unless that was done before.
void compile_kit_file(const Compiler& compiler, std::vector<std::string> arguments,
                      const std::string& object, ReadyKit& kit,
                      const std::function<bool()>& is_stopped) {
    std::error_code fault;
    if (kit.is_stopped || fs::is_regular_file(object, fault)) return;
    const std::string unfinished = unfinished_name(object);
    arguments.insert(arguments.end(), {"-w", "-I" + kit.folder, "-o", unfinished});
    const GuardedRun run =
        run_compiler(compiler.path, arguments, {kit.ready, {kit.folder}}, is_stopped);
    kit.has_landlock = kit.has_landlock && run.has_landlock;
    if (is_done(run)) return finish_file(unfinished, object);
    fs::remove(unfinished, fault);
    if (run.end != GuardedEnd::stopped) refuse(compiler, run);
    kit.is_stopped = true;
}

} // namespace

std::string written_kit() {
    const std::string mine = cache_folder() + "/mine";
    make_folder(mine);
    std::string folder = mine + "/kit-" + kit_version();
    write_kit(folder);
    mark_used(folder);
    return folder;
}

ReadyKit make_kit_ready(const Compiler& compiler, const std::vector<std::string>& flags,
                        const std::function<bool()>& is_stopped) {
    ReadyKit kit;
    kit.folder = written_kit();
    kit.ready = cache_folder() + "/mine/" + ready_name(compiler, flags);
    std::error_code fault;
    // A precompiled header takes 80 MB: those of former versions go when another is made.
    if (!fs::is_directory(kit.ready, fault)) forget_unused(cache_folder() + "/mine");
    make_folder(kit.ready);
    mark_used(kit.ready);
    const std::string claims = kit.folder + "/claims.h";

    std::vector<std::string> arguments = flags;
    arguments.insert(arguments.end(), {"-x", "c++-header", claims});
    if (compiler.is_clang) {
        const std::string header = kit.ready + "/claims.pch";
        compile_kit_file(compiler, arguments, header, kit, is_stopped);
        kit.including = {"-include-pch", header};
    } else {
        // g++ takes claims.h.gch in place of a claims.h next to it.
        const std::string header = kit.ready + "/claims.h";
        compile_kit_file(compiler, arguments, header + ".gch", kit, is_stopped);
        if (!fs::exists(header, fault))
            write_file(header, fmt::format("#include \"{}\"\n", claims));
        kit.including = {"-include", header};
    }

    for (const KitFile& file : kit_files()) {
        // What is in its folders is included, or is there to be copied.
        if (!file.name.ends_with(".cpp") || file.name.find('/') != std::string_view::npos) continue;
        const std::string object = fmt::format("{}/{}.o", kit.ready, file.name);
        arguments = flags;
        arguments.insert(arguments.end(), {"-c", fmt::format("{}/{}", kit.folder, file.name)});
        compile_kit_file(compiler, arguments, object, kit, is_stopped);
        kit.objects.push_back(object);
    }
    return kit;
}

} // namespace rasterwalk
