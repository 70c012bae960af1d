// Changed models, materials, scenes and figures.

#include <cstddef>
#include <string>
#include <string_view>

#include "figures/figure_drawing.h"
#include "scene/read_obj.h"
#include "scene/read_scene.h"
#include "support/changed_formats.h"

namespace rasterwalk::test {

const std::string changed_materials =
    "newmtl a\nKd 0.5 1 0.25\nKs 0.5\nNs 10\nd -halo 0.5\nTr 0.25\n"
    "map_Kd -s 2 2 -o .5 p.png\nbump -bm 2 p.png\ndisp -mm 0 .5 p.png\nnewmtl b c\nKd .2\n"
    "map_d \"p.png\" # a\nmap_Kd C:\\\\p.png\nnorm p.png\nillum 2\n"
    "newmtl c\nKd 0\n";
namespace {

const std::string painted_model =
    "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nvn 0 0 1\nusemtl a\n"
    "f 1/1/1 2/2/1 3/3/1\nusemtl b c\nf 1/1 3/3 2/2\n";

const std::string scene_seed =
    "name = \"s\"\nstage = \"edges\"\n[viewport]\nwidth = 40\nheight = 30\n[camera]\n"
    "position = [0, 0, -3]\nyaw = 0.5\n[light]\nposition = [0, -1, 0]\npower = [9, 9, 9]\n"
    "[points.p]\nA = [0, 0, 1]\nB = [1, 0, 1.5]\nC = [0, 1, 1e0]\n[materials.m]\n"
    "diffuse = [0.5, 0.5, 1]\nalpha = 0.5\n[[part]]\nname = \"q\"\npoints = \"p\"\n"
    "material = \"m\"\ntexture = \"p.png\"\ntexcoords = [[[0, 0], [1, 0], [0, 1]]]\n"
    "model = [{ scale = [2, 1, 1] }, { rotate_y = 0.5 }]\ntriangles = [\"A B C\"]\n";

FileOutcome model_outcome(const std::string& bytes, const TemporaryFolder& folder) {
    const std::string path = folder.file("m/m.obj");
    return text_outcome(path, folder.file("m/m.mtl"),
                        [&] { return problem_of_model(parse_obj(bytes, path)); });
}

FileOutcome material_outcome(const std::string& bytes, const TemporaryFolder& folder) {
    folder.write("m/changed/m.mtl", bytes);
    const std::string path = folder.file("m/changed/m.obj");
    bool is_whole = true;
    FileOutcome outcome = text_outcome(path, folder.file("m/changed/m.mtl"), [&] {
        const ObjModel model = parse_obj(painted_model, path);
        is_whole = model.report.counts.faults == 0;
        return problem_of_model(model);
    });
    outcome.is_read = outcome.is_read && is_whole;
    return outcome;
}

FileOutcome scene_outcome(const std::string& bytes, const TemporaryFolder& folder) {
    const std::string path = folder.file("m/s.toml");
    return text_outcome(path, path, [&] { return problem_of_scene(parse_scene(bytes, path)); });
}

// Figures

const std::string figure_seed =
    "<svg viewBox=\"0 0 90 60\">\n<style>.a{}</style><!-- b -->\n"
    "<g class=\"edge-1\" transform=\"translate(4, 5)\" data-if=\"stage == fill\">\n"
    "<line class=\"dashed arrow\" x1=\"1\" y1=\"2\" x2=\"30\" y2=\"4\"/>\n"
    "<polygon class=\"soft\" points=\"0,0 9,0 9,9\" data-points=\"1;2;camera.yaw;4;5;6\"/></g>\n"
    "<circle cx=\"50\" cy=\"5\" r=\"4\" data-cx=\"camera.focal_length / 10\""
    " data-drag=\"camera.focal_length 100 900 50\"/>\n"
    "<path d=\"M0 0 L1 1 Q2 3 4 5 C1 2 3 4 5 6 Z\"/><rect x=\"1\" y=\"2\" width=\"3\" "
    "height=\"4\"/>\n"
    "<text x=\"3\" y=\"4\">p<tspan class=\"sub\" data-value=\"pixel.z\">1</tspan> &lt; 4</text>\n"
    "</svg>\n";

FileOutcome figure_outcome(const std::string& bytes, const TemporaryFolder&) {
    try {
        const Figure figure = read_figure(bytes, "x");
        const FactReader no_facts = [](std::string_view) { return Value(); };
        const FigureDrawing drawing = draw_figure(figure, no_facts);
        std::size_t places = 0;
        bool is_short = false;
        for (const FigureLine& line : drawing.lines) {
            places += line.places.size();
            is_short = is_short || line.places.size() < 2;
        }
        if (is_short) return {true, "a line of it has less than two places."};
        for (const FigureHandle& handle : figure.handles)
            dragged_value(figure, handle, {0.0f, 0.0f}, no_facts);
        return {true, places <= 100'000 ? "" : "it is drawn through too many places."};
    } catch (const InputError& fault) {
        const std::string said = fault.what();
        return {false, problem_of_refusal(said, said.starts_with("x:"))};
    }
}

const std::vector<std::string> figure_words{
    "<",       ">",      "/>",       "</g>",      "<g>",   "\"",   "'",
    "&",       "&lt;",   "<!--",     "-->",       "<?xml", "<!",   "<text x='0' y='0'>",
    "<tspan>", "class=", "1e9",      "-1",        "nan",   "M",    "Z",
    ";",       "(",      "data-x1=", "data-if='", "soft",  "\x80", "<defs>",
    "<style>"};

const std::vector<std::string> model_words{
    "nan",     "-inf",    "1e999", "0",    "-1",  "4294967297", "9223372036854775808",
    "/",       "//",      "\\",    "\\\n", "#",   "f ",         "v ",
    "mtllib ", "usemtl ", "\n",    "\r",   "g ",  "1/1/1",      "\x80",
    "1e-50",   "#MRGB 7", "+",     "-",    "1e9", " ",          "\t"};

const std::vector<std::string> material_words{
    "newmtl ", "usemtl ", "Kd ",   "Ks ",   "d ",    "Tr ",   "Ns ",     "map_Kd ",
    "map_d ",  "bump ",   "disp ", "norm ", "p.png", "-bm ",  "-o 1 2 ", "-s ",
    "\"",      "'",       "#",     "..",    "/",     "\\",    "\n",      "\r",
    "1e99",    "nan",     "-1",    "2",     "\x80",  "m.obj", "m.mtl\n"};

} // namespace

std::vector<ChangedFormat> model_formats() {
    std::vector<std::string> models = model_seeds();
    models.push_back(painted_model);
    return {
        {"OBJ", models, model_words, model_outcome},
        {"MTL", {changed_materials}, material_words, material_outcome},
        {"scene", {scene_seed}, toml_words, scene_outcome},
        {"figure", {figure_seed}, figure_words, figure_outcome},
    };
}

} // namespace rasterwalk::test
