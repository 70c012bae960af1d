// What a figure's file says is read; what it may not say is refused with its line.

#include <string>

#include "base/error.h"
#include "figures/figure.h"
#include "figures/figure_tags.h"
#include "tests/support/catch.h"

using namespace rasterwalk;

namespace {

std::string figure_with(const std::string& inside) {
    return "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 300 100\">\n" + inside +
           "\n</svg>\n";
}

/// What is said about a whole file.
std::string refusal_of_file(const std::string& text) {
    try {
        read_figure(text, "a.svg");
    } catch (const InputError& fault) {
        return fault.what();
    }
    return "it is read";
}

/// What is said about an element in line 2.
std::string refusal(const std::string& inside) {
    return refusal_of_file(figure_with(inside));
}

constexpr const char* all_kinds = R"svg(<title>words</title>
<!-- a remark -->
<g class="edge-1 bold" transform="translate(10, 20)">
  <line x1="1" y1="2" x2="3.5" y2="-4" class="dashed thick"/>
  <g transform="translate(5)"><text x="7" y="8" text-anchor="end">
     p <tspan class="sub quiet">i</tspan> &lt; 4
  </text></g>
</g>
<path class="pass arrow" d="M0 0 L1,2 Q3 4 5 6 C1 2 3 4 5 6 Z"/>)svg";

} // namespace

TEST_CASE("A figure is read with its groups, classes and texts") {
    const Figure figure = read_figure(figure_with(all_kinds), "a.svg");
    CHECK(figure.size == glm::vec2(300.0f, 100.0f));
    REQUIRE(figure.groups.size() == 3);
    CHECK(figure.groups[1].outer == 0);
    CHECK(figure.groups[2].outer == 1);
    CHECK(figure.groups[2].x.value == 5.0f);
    CHECK(figure.groups[2].y.value == 0.0f);
    REQUIRE(figure.shapes.size() == 3);
    const FigureShape& line = figure.shapes[0];
    CHECK(line.look.colour == FigureColour::edge_1);
    CHECK(line.look.is_bold);
    CHECK(line.look.is_dashed);
    CHECK(line.look.is_thick);
    CHECK_FALSE(line.look.is_thin);
    REQUIRE(line.numbers.size() == 4);
    CHECK(line.numbers[3].value == -4.0f);
    CHECK(line.line == 5);
    const FigureShape& text = figure.shapes[1];
    CHECK(text.anchor == FigureShape::Anchor::end);
    REQUIRE(text.spans.size() == 3);
    CHECK(text.spans[0].text == "p ");
    CHECK(text.spans[1].text == "i");
    CHECK(text.spans[1].is_lowered);
    CHECK(text.spans[1].look.colour == FigureColour::quiet);
    CHECK(text.spans[2].text == " < 4");
    CHECK(text.spans[2].look.colour == FigureColour::edge_1);
    const FigureShape& path = figure.shapes[2];
    CHECK(path.commands == "MLQCZ");
    CHECK(path.numbers.size() == 14);
    CHECK(path.look.has_arrow);
    CHECK(path.look.colour == FigureColour::pass); // the group is closed
}

TEST_CASE("What follows and what can be dragged is read") {
    const Figure figure = read_figure(
        figure_with(R"svg(<circle cx="50" cy="40" r="5" data-cx="camera.focal_length / 10"
  data-drag="camera.focal_length 100 900 50"/>
<g data-if="stage == edges"><text x="0" y="9">f = <tspan data-value="camera.focal_length"
  data-digits="1">500.0</tspan></text></g>)svg"),
        "a.svg");
    REQUIRE(figure.handles.size() == 1);
    CHECK(figure.handles[0].setting == "camera.focal_length");
    CHECK(figure.handles[0].range.smallest == 100.0);
    CHECK(figure.handles[0].range.largest == 900.0);
    CHECK(figure.handles[0].range.step == 50.0);
    REQUIRE(figure.expressions.size() == 2);
    CHECK(figure.expressions[0].as_written == 50.0f);
    CHECK(figure.expressions[1].as_written == 500.0f);
    CHECK(figure.expressions[1].line == 4);
    CHECK(figure.conditions.size() == 1);
    CHECK(figure.groups[1].shown_if == 0);
    CHECK(figure.shapes[1].spans[1].digits == 1);
}

TEST_CASE("What is no figure is refused with its line") {
    CHECK(refusal_of_file("") == "a.svg:1: there is nothing in this file.");
    CHECK(refusal_of_file("<html></html>") == "a.svg:1: the outermost element must be <svg>.");
    CHECK(refusal_of_file("<svg></svg>") == "a.svg:1: <svg> needs 'viewBox'.");
    CHECK(refusal_of_file("<svg viewBox=\"0 0 10 0\"></svg>") ==
          "a.svg:1: viewBox: write \"0 0 WIDTH HEIGHT\", each 1 to 2000.");
    CHECK(refusal_of_file("<svg viewBox=\"0 0 9 9\">\n") ==
          "a.svg:2: the element <svg> is not closed.");
    CHECK(refusal_of_file("<!DOCTYPE svg>") ==
          "a.svg:1: only elements and comments are read here.");
    CHECK(refusal_of_file("<svg viewBox=\"0 0 9 9\"/>\n<svg/>") ==
          "a.svg:2: there must be one outermost element.");
    CHECK(refusal_of_file(std::string("<svg \x01/>")) ==
          "a.svg:1: a control character is not text.");
    CHECK(refusal_of_file("<svg \xff/>") == "a.svg: the file is not UTF-8.");
    CHECK(refusal_of_file(std::string(largest_figure + 1, ' ')) ==
          "a.svg: a figure may have at most 65536 bytes.");
    CHECK(refusal("words") == "a.svg:1: text belongs in <text>.");
    CHECK(refusal("<text x='1' y='1'>&#8710;</text>") ==
          "a.svg:2: only &amp;, &lt;, &gt;, &quot; and &apos; may begin with &.");
    CHECK(refusal("<g></svg>") == "a.svg:2: </svg> closes nothing; <g> is open.");
    CHECK(refusal("<g class=x></g>") == "a.svg:2: write an attribute as name=\"value\".");
    CHECK(refusal("<g class='a'class='b'/>") ==
          "a.svg:2: a blank is missing before this attribute.");
    CHECK(refusal("<g class='ink' class='ink'/>") ==
          "a.svg:2: the attribute 'class' is there twice.");
}

TEST_CASE("What a figure has no use for is refused with its line") {
    CHECK(refusal("<lien x1='1'/>") ==
          "a.svg:2: there is no element 'lien'; choose from g, line, polyline, polygon, rect, "
          "circle, path, text. Did you mean 'line'?");
    CHECK(refusal("<line x1='1' y1='2' x2='3'/>") == "a.svg:2: <line> needs 'y2'.");
    CHECK(refusal("<circle cx='1' cy='2' r='3'\nfill='red'/>") ==
          "a.svg:3: <circle> has no attribute 'fill'.");
    CHECK(refusal("<circle cx='1e9' cy='2' r='3'/>") ==
          "a.svg:2: cx: '1e9' is not a number from -100000 to 100000.");
    CHECK(refusal("<g class='dashed'/>") ==
          "a.svg:2: class: a group does not pass the class 'dashed' on to its parts; give it to "
          "them.");
    CHECK(refusal("<g transform='rotate(3)'/>") ==
          "a.svg:2: transform: the only transform is translate(x, y).");
    CHECK(refusal("<path d='M0 0 l1 1'/>") ==
          "a.svg:2: d: a path has the commands M, L, Q, C and Z, each with its letter, not 'l'.");
    CHECK(refusal("<path d='M0 0 Q1 1'/>") == "a.svg:2: d: Q takes 4 numbers, not 2.");
    CHECK(refusal("<path class='arrow' d='M0 0 Z'/>") ==
          "a.svg:2: d: a path has at least two places.");
    CHECK(refusal("<path d='L0 0 L1 1'/>") ==
          "a.svg:2: d: a path begins with M and has no second one.");
    CHECK(refusal("<path d='M0 0 L1 1 Z L2 2'/>") ==
          "a.svg:2: d: Z is the last command of a path.");
    CHECK(refusal("<polygon points='0 0 1 1'/>") ==
          "a.svg:2: <polygon> needs at least 3 corners, each x and y.");
    CHECK(refusal("<polygon class='soft' points='0,0 9,0 1,1 0,9'/>") ==
          "a.svg:2: what is filled must not be dented; draw it in parts.");
    CHECK(refusal("<polygon points='0,0 9,0 1,1 0,9'/>") == "it is read");
    CHECK(refusal("<polyline points='0 0 1 1' data-points='1; 2'/>") ==
          "a.svg:2: data-points has 2 expressions, points has 4 numbers.");
    CHECK(refusal("<text x='1' y='2'> </text>") == "a.svg:2: the text is empty.");
    CHECK(refusal("<text x='1' y='2'>a<g/></text>") ==
          "a.svg:2: in <text> there may be <tspan>, and nothing in that.");
    CHECK(refusal("<circle cx='1' cy='2' r='3'>a</circle>") ==
          "a.svg:2: nothing may be in <circle>.");
}

TEST_CASE("An expression that is not understood is refused with its line") {
    CHECK(refusal("<circle cx='1' cy='2' r='3' data-cx='camera.focal_lenght'/>")
              .find("a.svg:2: data-cx: ") == 0);
    CHECK(refusal("<g data-if='stage == egdes'/>").find("a.svg:2: data-if: ") == 0);
    CHECK(refusal("<circle cx='1' cy='2' r='3' data-drag='stage 1 2 1'/>")
              .find("a.svg:2: data-drag: there is no setting 'stage' whose value is one number.") ==
          0);
    CHECK(refusal("<circle cx='1' cy='2' r='3' data-drag='camera.focal_length 100 900 50'/>") ==
          "a.svg:2: what can be dragged must have data-cx or data-cy that depends on the setting.");
    CHECK(refusal("<circle cx='1' cy='2' r='3' data-drag='camera.focal_length 100 900 0.01'/>") ==
          "a.svg:2: data-drag: from the first number to the second there are 1 to 1000 steps.");
    CHECK(refusal("<g display='none'/>") == "a.svg:2: display is \"none\", and goes with data-if.");
    CHECK(refusal("<g display='none' data-if='stage == edges'/>") == "it is read");
    CHECK(refusal("<text x='1' y='2' data-digits='2'>4</text>") ==
          "a.svg:2: data-digits is 0 to 6, and goes with data-value.");
}

TEST_CASE("A figure beyond the limits is refused") {
    std::string deep;
    for (std::size_t i = 0; i < deepest_figure; ++i)
        deep += "<g>";
    CHECK(refusal(deep) == "a.svg:2: elements may be nested 12 deep.");
    std::string many;
    for (std::size_t i = 0; i <= most_figure_shapes; ++i)
        many += "<line x1='1' y1='1' x2='2' y2='2'/>";
    CHECK(refusal(many) == "a.svg:2: a figure may have at most 400 shapes.");
    // Groups are worked out in each frame, too.
    std::string groups;
    for (std::size_t i = 0; i < most_figure_numbers / 2; ++i)
        groups += "<g></g>";
    CHECK(refusal(groups) == "a.svg:2: a figure may have at most 4000 numbers.");
    std::string long_line;
    for (std::size_t i = 0; i < most_figure_numbers; ++i)
        long_line += "1 2 ";
    CHECK(refusal("<polyline points='" + long_line + "'/>") ==
          "a.svg:2: a figure may have at most 4000 numbers.");
}
