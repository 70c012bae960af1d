#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

#include "base/error.h"
#include "code/code_syntax.h"

namespace rasterwalk {

namespace {

using Kind = CodeExpression::Kind;
using TokenKind = CodeToken::Kind;
using StatementKind = CodeStatement::Kind;

/// Nested deeper than this, a source is not read: reading it takes room on the stack.
constexpr int most_nested = 200;

/// Parts of the expressions of one statement: each may be a level deeper than the one before.
constexpr int most_parts = 2000;

/// The binary operators, from weak to strong.
constexpr std::array<std::array<std::string_view, 4>, 6> strengths{{
    {"||"},
    {"&&"},
    {"==", "!="},
    {"<", "<=", ">", ">="},
    {"+", "-"},
    {"*", "/", "%"},
}};

constexpr std::array<std::string_view, 6> assignments{"=", "+=", "-=", "*=", "/=", "%="};

/// Words that begin statements which are not understood.
constexpr std::array<std::string_view, 6> refused_words{"do",  "switch", "goto",
                                                        "try", "auto",   "class"};

/// Words before a type that change nothing here.
constexpr std::array<std::string_view, 4> storage_words{"static", "inline", "constexpr", "const"};

constexpr std::array<std::string_view, 4> number_words{"int", "float", "double", "bool"};

template <class Words>
bool contains_word(const Words& words, std::string_view word) {
    return !word.empty() && std::find(words.begin(), words.end(), word) != words.end();
}

class CodeParser {
  public:
    CodeParser(std::string_view source, const std::string& file)
        : file_(file), cut_(tokens_of(source, file)) {}

    CodeSyntax parse() {
        while (now().kind != TokenKind::end)
            parse_top();
        syntax_.file = file_;
        syntax_.marks = std::move(cut_.marks);
        return std::move(syntax_);
    }

    CodeExpressionPtr parse_alone() {
        CodeExpressionPtr value = expression();
        if (now().kind != TokenKind::end) fail("The expression goes on with " + quoted(now()));
        return value;
    }

  private:
    /// Counts how deeply what is read is nested.
    class Nested {
      public:
        explicit Nested(CodeParser& parser) : parser_(parser) {
            if (++parser_.depth_ > most_nested) parser_.fail("This is nested too deeply");
        }
        ~Nested() { --parser_.depth_; }
        Nested(const Nested&) = delete;
        Nested& operator=(const Nested&) = delete;

      private:
        CodeParser& parser_;
    };

    // Tokens.

    const CodeToken& now() const { return cut_.tokens[at_]; }
    const CodeToken& ahead(std::size_t count) const {
        return cut_.tokens[std::min(at_ + count, cut_.tokens.size() - 1)];
    }
    bool is(std::string_view text) const {
        return now().text == text && now().kind != TokenKind::text;
    }
    bool is_name() const { return now().kind == TokenKind::name; }

    const CodeToken& take() {
        const CodeToken& token = now();
        if (token.kind != TokenKind::end) ++at_;
        return token;
    }
    bool take_if(std::string_view text) {
        const bool found = is(text);
        if (found) take();
        return found;
    }

    static std::string quoted(const CodeToken& token) {
        return token.kind == TokenKind::end ? "the end of the file"
                                            : "`" + std::string(token.text) + "`";
    }

    [[noreturn]] void fail(const std::string& sentence) const { fail_at(now().line, sentence); }
    [[noreturn]] void fail_at(int line, const std::string& sentence) const {
        throw InputError(file_, line, sentence + ".");
    }

    /// A missing sign belongs to the line of the previous token.
    void expect(std::string_view text) {
        if (take_if(text)) return;
        const int line = at_ > 0 ? cut_.tokens[at_ - 1].line : now().line;
        fail_at(line, fmt::format("`{}` is missing before {}", text, quoted(now())));
    }

    std::string expect_name(std::string_view what) {
        if (!is_name()) fail(fmt::format("{} is missing before {}", what, quoted(now())));
        return std::string(take().text);
    }

    // Types.

    /// A name of the namespaces that everybody uses is left out.
    void skip_namespace() {
        while (is_name() && ahead(1).text == "::" && (is("std") || is("glm"))) {
            take();
            take();
        }
    }

    WrittenType written_type() {
        WrittenType type;
        type.line = now().line;
        while (contains_word(storage_words, now().text))
            type.is_const |= take().text == "const";
        skip_namespace();
        type.name = expect_name("A type");
        if (type.name == "unsigned" && is("int")) take();
        if (type.name == "struct") type.name = expect_name("The name of a type");
        if (take_if("<")) {
            skip_namespace();
            type.element = expect_name("The type of the elements");
            expect(">");
        }
        if (take_if("const")) type.is_const = true;
        if (is("*")) fail("Pointers are not understood here");
        type.is_reference = take_if("&");
        return type;
    }

    /// Does a declaration begin here: a type, and then a name?
    bool is_declaration() const {
        std::size_t i = 0;
        bool has_storage = false;
        while (contains_word(storage_words, ahead(i).text)) {
            has_storage = true;
            ++i;
        }
        if (has_storage) return true;
        while (ahead(i).kind == TokenKind::name && ahead(i + 1).text == "::")
            i += 2;
        if (ahead(i).kind != TokenKind::name) return false;
        if (ahead(i).text == "unsigned" && ahead(i + 1).text == "int") ++i;
        ++i;
        if (ahead(i).text == "<") {
            while (ahead(i).text == "<" || ahead(i).kind == TokenKind::name ||
                   ahead(i).text == "::")
                ++i;
            if (ahead(i).text != ">") return false;
            ++i;
        }
        if (ahead(i).text == "const") ++i;
        if (ahead(i).text == "&") ++i;
        // Only then is it no product.
        if (ahead(i).text == "*") return contains_word(number_words, ahead(i - 1).text);
        return ahead(i).kind == TokenKind::name;
    }

    // Expressions.

    CodeExpressionPtr make(Kind kind, int line, std::string text = {}) {
        if (++parts_ > most_parts) fail("This expression is too long");
        auto made = std::make_unique<CodeExpression>();
        made->kind = kind;
        made->line = line;
        made->text = std::move(text);
        return made;
    }

    CodeExpressionPtr expression() {
        const Nested nested(*this);
        CodeExpressionPtr left = conditional();
        if (!contains_word(assignments, now().text)) return left;
        const CodeToken& sign = take();
        CodeExpressionPtr whole = make(Kind::assign, sign.line, std::string(sign.text));
        whole->parts.push_back(std::move(left));
        whole->parts.push_back(is("{") ? list() : expression());
        return whole;
    }

    CodeExpressionPtr conditional() {
        CodeExpressionPtr condition = binary(0);
        if (!is("?")) return condition;
        CodeExpressionPtr whole = make(Kind::conditional, take().line);
        whole->parts.push_back(std::move(condition));
        whole->parts.push_back(expression());
        expect(":");
        whole->parts.push_back(expression());
        return whole;
    }

    CodeExpressionPtr binary(std::size_t strength) {
        if (strength == strengths.size()) return unary();
        CodeExpressionPtr left = binary(strength + 1);
        for (int parts = 1; contains_word(strengths[strength], now().text); ++parts) {
            // The tree grows by one level for each.
            if (parts > most_nested) fail("This expression is too long");
            const CodeToken& sign = take();
            CodeExpressionPtr whole = make(Kind::binary, sign.line, std::string(sign.text));
            whole->parts.push_back(std::move(left));
            whole->parts.push_back(binary(strength + 1));
            left = std::move(whole);
        }
        return left;
    }

    /// Is this `(float)` before a value?
    bool is_cast() const {
        return is("(") && contains_word(number_words, ahead(1).text) && ahead(2).text == ")";
    }

    CodeExpressionPtr unary() {
        const Nested nested(*this);
        const CodeToken& first = now();
        if (is("-") || is("+") || is("!")) {
            CodeExpressionPtr whole = make(Kind::unary, first.line, std::string(take().text));
            whole->parts.push_back(unary());
            return whole;
        }
        if (is("++") || is("--")) {
            CodeExpressionPtr whole = make(Kind::before, first.line, std::string(take().text));
            whole->parts.push_back(unary());
            return whole;
        }
        if (is_cast()) {
            take();
            CodeExpressionPtr whole = make(Kind::call, first.line, std::string(take().text));
            take();
            whole->parts.push_back(unary());
            return whole;
        }
        return postfix(primary());
    }

    void arguments(std::vector<CodeExpressionPtr>& into, std::string_view close) {
        while (!is(close)) {
            into.push_back(is("{") ? list() : expression());
            if (!take_if(",")) break;
        }
        expect(close);
    }

    CodeExpressionPtr list() {
        const Nested nested(*this);
        CodeExpressionPtr whole = make(Kind::list, now().line);
        expect("{");
        arguments(whole->parts, "}");
        return whole;
    }

    CodeExpressionPtr primary() {
        const CodeToken& token = now();
        const std::string text(token.text);
        switch (token.kind) {
        case TokenKind::integer:
            take();
            return make(Kind::integer, token.line, text);
        case TokenKind::real:
            take();
            return make(Kind::real, token.line, text);
        case TokenKind::single_real:
            take();
            return make(Kind::single_real, token.line, text);
        case TokenKind::text:
            take();
            return make(Kind::text, token.line, text);
        case TokenKind::name:
            return named();
        case TokenKind::sign:
        case TokenKind::end:
            break;
        }
        if (take_if("(")) {
            CodeExpressionPtr inner = expression();
            expect(")");
            return inner;
        }
        fail(fmt::format("A value is missing before {}", quoted(token)));
    }

    CodeExpressionPtr named() {
        skip_namespace();
        const CodeToken& token = now();
        std::string name = expect_name("A name");
        if (name == "true" || name == "false") return make(Kind::boolean, token.line, name);
        if (is("::")) fail("Only the namespaces std and glm are understood here");
        if (name == "static_cast" && take_if("<")) {
            CodeExpressionPtr whole =
                make(Kind::call, token.line, expect_name("The type of the cast"));
            expect(">");
            expect("(");
            arguments(whole->parts, ")");
            return whole;
        }
        if (name == "vector" && is("<")) fail("A vector is made by declaring it");
        const bool is_made_of_list =
            is("{") && std::isupper(static_cast<unsigned char>(name[0])) != 0;
        if (!is("(") && !is_made_of_list) return make(Kind::name, token.line, std::move(name));
        CodeExpressionPtr whole = make(Kind::call, token.line, std::move(name));
        const std::string_view close = take().text == "(" ? ")" : "}";
        arguments(whole->parts, close);
        return whole;
    }

    CodeExpressionPtr postfix(CodeExpressionPtr value) {
        for (int parts = 1;; ++parts) {
            if (parts > most_nested) fail("This expression is too long");
            const int line = now().line;
            if (take_if("[")) {
                CodeExpressionPtr whole = make(Kind::index, line);
                whole->parts.push_back(std::move(value));
                whole->parts.push_back(expression());
                expect("]");
                value = std::move(whole);
            } else if (take_if(".")) {
                std::string name = expect_name("The name of a member");
                CodeExpressionPtr whole =
                    make(is("(") ? Kind::method : Kind::member, line, std::move(name));
                whole->parts.push_back(std::move(value));
                if (take_if("(")) arguments(whole->parts, ")");
                value = std::move(whole);
            } else if (is("++") || is("--")) {
                CodeExpressionPtr whole = make(Kind::after, line, std::string(take().text));
                whole->parts.push_back(std::move(value));
                value = std::move(whole);
            } else if (is("->")) {
                fail("Pointers are not understood here");
            } else {
                return value;
            }
        }
    }

    // Statements.

    CodeStatementPtr begin(StatementKind kind) const {
        auto made = std::make_unique<CodeStatement>();
        made->kind = kind;
        made->line = made->end_line = now().line;
        return made;
    }

    CodeStatementPtr block() {
        const Nested nested(*this);
        CodeStatementPtr made = begin(StatementKind::block);
        expect("{");
        while (!is("}")) {
            if (now().kind == TokenKind::end) fail_at(made->line, "This `{` has no `}`");
            made->inner.push_back(statement());
        }
        made->end_line = take().line;
        return made;
    }

    CodeVariable variable() {
        CodeVariable made;
        made.line = now().line;
        made.name = expect_name("The name of a variable");
        while (take_if("[")) {
            made.sizes.push_back(expression());
            expect("]");
        }
        if (take_if("=")) {
            made.value = is("{") ? list() : expression();
        } else if (is("{")) {
            made.value = list();
        } else if (take_if("(")) {
            arguments(made.arguments, ")");
        }
        return made;
    }

    /// The variables after the type, up to the semicolon.
    CodeStatementPtr declaration_of(WrittenType type, CodeStatementPtr made) {
        parts_ = 0;
        made->type = std::move(type);
        do {
            made->variables.push_back(variable());
        } while (take_if(","));
        expect(";");
        return made;
    }

    CodeStatementPtr declaration() {
        CodeStatementPtr made = begin(StatementKind::declare);
        WrittenType type = written_type();
        return declaration_of(std::move(type), std::move(made));
    }

    CodeStatementPtr expression_statement() {
        CodeStatementPtr made = begin(StatementKind::express);
        made->value = expression();
        expect(";");
        return made;
    }

    CodeStatementPtr simple_statement() {
        return is_declaration() ? declaration() : expression_statement();
    }

    CodeExpressionPtr condition_in_parentheses() {
        expect("(");
        CodeExpressionPtr value = expression();
        expect(")");
        return value;
    }

    CodeStatementPtr choice() {
        CodeStatementPtr made = begin(StatementKind::choose);
        take();
        made->value = condition_in_parentheses();
        made->inner.push_back(statement());
        if (take_if("else")) made->inner.push_back(statement());
        return made;
    }

    CodeStatementPtr repetition() {
        CodeStatementPtr made = begin(StatementKind::repeat);
        take();
        made->value = condition_in_parentheses();
        made->inner.push_back(statement());
        return made;
    }

    /// for (const Pixel& p : pixels)
    bool is_for_each() const {
        if (!is_declaration()) return false;
        for (std::size_t i = 0; ahead(i).kind != TokenKind::end; ++i) {
            if (ahead(i).text == ":") return true;
            if (ahead(i).text == ";" || ahead(i).text == "(" || ahead(i).text == "=") return false;
        }
        return false;
    }

    CodeStatementPtr loop() {
        CodeStatementPtr made = begin(StatementKind::count);
        take();
        expect("(");
        if (is_for_each()) {
            made->kind = StatementKind::for_each;
            made->type = written_type();
            CodeVariable element;
            element.line = now().line;
            element.name = expect_name("The name of a variable");
            made->variables.push_back(std::move(element));
            expect(":");
            made->value = expression();
            expect(")");
            made->inner.push_back(statement());
            return made;
        }
        if (is(";")) {
            made->inner.push_back(begin(StatementKind::nothing));
            take();
        } else {
            made->inner.push_back(simple_statement());
        }
        if (!is(";")) made->value = expression();
        expect(";");
        if (!is(")")) made->next = expression();
        expect(")");
        made->inner.push_back(statement());
        return made;
    }

    CodeStatementPtr jump(StatementKind kind) {
        CodeStatementPtr made = begin(kind);
        take();
        if (kind == StatementKind::give_back && !is(";"))
            made->value = is("{") ? list() : expression();
        expect(";");
        return made;
    }

    CodeStatementPtr statement() {
        const Nested nested(*this);
        parts_ = 0;
        if (is("{")) return block();
        if (is(";")) {
            CodeStatementPtr made = begin(StatementKind::nothing);
            take();
            return made;
        }
        if (is("if")) return choice();
        if (is("while")) return repetition();
        if (is("for")) return loop();
        if (is("return")) return jump(StatementKind::give_back);
        if (is("break")) return jump(StatementKind::leave);
        if (is("continue")) return jump(StatementKind::go_on);
        if (contains_word(refused_words, now().text))
            fail(fmt::format("`{}` is not understood here", now().text));
        // The analyzer loses sight of what the pointer owns.
        return simple_statement(); // NOLINT(clang-analyzer-cplusplus.NewDeleteLeaks)
    }

    // The outermost level.

    void parse_struct() {
        WrittenStruct made;
        made.line = take().line;
        made.name = expect_name("The name of the struct");
        expect("{");
        while (!take_if("}")) {
            const WrittenType type = written_type();
            do {
                made.fields.push_back({type, expect_name("The name of a member")});
            } while (take_if(","));
            if (is("(")) fail("Functions of a struct are not understood here");
            if (is("=")) fail("Members with a value of their own are not understood here");
            expect(";");
        }
        expect(";");
        syntax_.structs.push_back(std::move(made));
    }

    /// Does a function begin here: a type, a name, and then parentheses that hold parameters?
    bool is_function_after(std::size_t name) const {
        if (ahead(name + 1).text != "(") return false;
        const CodeToken& first = ahead(name + 2);
        if (first.text == ")") return true;
        if (first.kind != TokenKind::name) return false;
        if (first.text == "const") return true;
        const CodeToken& second = ahead(name + 3);
        return second.kind == TokenKind::name || second.text == "<" || second.text == "&" ||
               second.text == "::" || second.text == "*";
    }

    void parse_function(WrittenType result) {
        WrittenFunction made;
        made.result = std::move(result);
        made.line = now().line;
        made.name = expect_name("The name of the function");
        expect("(");
        if (is("void") && ahead(1).text == ")") take();
        while (!is(")")) {
            WrittenType type = written_type();
            std::string name = is_name() ? std::string(take().text) : std::string();
            made.parameters.push_back({std::move(type), std::move(name)});
            if (!take_if(",")) break;
        }
        expect(")");
        if (is("{")) {
            made.body = block();
        } else {
            expect(";");
        }
        syntax_.functions.push_back(std::move(made));
    }

    void parse_using() {
        while (!take_if(";")) {
            if (now().kind == TokenKind::end) expect(";");
            take();
        }
    }

    void parse_top() {
        if (take_if(";")) return;
        if (is("using")) return parse_using();
        if (is("struct") && ahead(2).text == "{") return parse_struct();
        for (const std::string_view word : {"class", "template", "namespace", "enum", "typedef"})
            if (is(word)) fail(fmt::format("`{}` is not understood here", word));
        CodeStatementPtr made = begin(StatementKind::declare);
        WrittenType type = written_type();
        if (is_function_after(0)) return parse_function(std::move(type));
        syntax_.globals.push_back(declaration_of(std::move(type), std::move(made)));
    }

    std::string file_;
    CodeTokens cut_;
    std::size_t at_ = 0;
    int depth_ = 0;
    int parts_ = 0; ///< of expressions, since the last statement began
    CodeSyntax syntax_;
};

} // namespace

CodeSyntax parse_code(std::string_view source, const std::string& file) {
    return CodeParser(source, file).parse();
}

CodeExpressionPtr parse_code_expression(std::string_view source, const std::string& file) {
    return CodeParser(source, file).parse_alone();
}

} // namespace rasterwalk
