#include "compiler/nodelang/hlsl/jumps.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>
#include <utility>

#include "compiler/nodelang/parse.h"

namespace patina::nodelang {
namespace {

using Flags = std::set<std::string_view>;  // bools that say that something has jumped

// `in_loop`, `in_switch`: the list is inside of one that the question is not about.
bool may_leave(const Statements& list, bool in_loop = false, bool in_switch = false) {
    return std::any_of(list.begin(), list.end(), [&](const Stmt* s) {
        if (s->kind == Stmt::Kind::Return) return true;
        if (s->kind == Stmt::Kind::Continue) return !in_loop;
        if (s->kind == Stmt::Kind::Break) return !in_loop && !in_switch;
        const bool is_loop = s->kind == Stmt::Kind::Loop;
        return may_leave(s->body, in_loop || is_loop, in_switch || is_loop || s->takes_break) ||
               may_leave(s->alternative, in_loop, in_switch);
    });
}

bool contains(const Statements& list, Stmt::Kind kind) {
    return std::any_of(list.begin(), list.end(), [&](const Stmt* s) {
        return s->kind == kind || contains(s->body, kind) || contains(s->alternative, kind);
    });
}

void collect_names(const Expr* expr, Flags& into) {
    if (!expr) return;
    if (expr->kind == Expr::Kind::Name || expr->kind == Expr::Kind::Call) into.insert(expr->text);
    for (const Expr* arg : expr->args) collect_names(arg, into);
}
void collect_names(const Statements& list, Flags& into) {
    for (const Stmt* s : list) {
        if (s->kind == Stmt::Kind::Declare) into.insert(s->name);
        for (const Expr* expr : {s->target, s->value, s->limit}) collect_names(expr, into);
        collect_names(s->body, into);
        collect_names(s->alternative, into);
        collect_names(s->step, into);
    }
}

// What a jump leaves: a switch, the round of a loop, or the function.
struct Region {
    bool is_loop = false, is_switch = false;
    bool is_at_end = true;       // nothing follows in it where the statements are now
    std::string_view flag{};     // the rest of it is left out; empty: nobody has needed that
    std::string_view running{};  // of a loop: false if there is no further round; empty as above
    Flags ends{};                // of a loop: flags of regions around it that end it, too
};

class Remover {
public:
    Remover(FunctionDecl& function, Ast& ast, Diagnostics& diagnostics, bool keeps_returns)
        : function_(function), ast_(ast), diagnostics_(diagnostics), keeps_returns_(keeps_returns) {
        collect_names(function.body, names_);
        for (const ParamDecl& param : function.params) names_.insert(param.name);
    }

    // False: this cannot be done while returns stay in branches.
    bool run() {
        const bool has_value = function_.result.name != "void";
        if (has_value && !keeps_returns_) result_ = fresh("result");
        regions_.push_back({});
        Flags set;
        Statements body = process(function_.body, set);
        const Region whole = regions_.back();
        if (is_stuck_ && !is_too_deep_) return false;
        const bool returns = always_leaves(function_.body);
        if (!whole.flag.empty()) body.insert(body.begin(), declare("bool", whole.flag, boolean(false)));
        if (!result_.empty()) {
            Stmt result{.kind = Stmt::Kind::Declare, .span = span(), .type = function_.result, .name = result_};
            result.name_span = span();
            body.insert(body.begin(), add(std::move(result)));
            if (returns) body.push_back(add({.kind = Stmt::Kind::Return, .span = span(), .value = name(result_)}));
        }
        function_.body = std::move(body);
        return true;
    }

private:
    Span span() const { return function_.name_span; }

    // --- new statements and expressions
    std::string_view fresh(std::string_view wanted) {
        std::string_view made = wanted;
        for (int i = 2; names_.contains(made); ++i) made = ast_.texts.emplace_back(fmt::format("{}{}", wanted, i));
        names_.insert(made);
        return made;
    }
    const Stmt* add(Stmt stmt) { return &ast_.stmts.emplace_back(std::move(stmt)); }
    const Expr* add(Expr expr) {
        expr.span = expr.name_span = span();
        return &ast_.exprs.emplace_back(std::move(expr));
    }
    const Expr* name(std::string_view text) { return add(Expr{.kind = Expr::Kind::Name, .text = text}); }
    const Expr* boolean(bool value) {
        return add(Expr{.kind = Expr::Kind::Bool, .text = value ? "true" : "false", .number = value ? 1.0 : 0.0});
    }
    const Stmt* declare(std::string_view type, std::string_view name, const Expr* value) {
        return add(Stmt{.kind = Stmt::Kind::Declare,
                        .span = span(),
                        .type = {.name = type, .span = span()},
                        .name = name,
                        .name_span = span(),
                        .value = value});
    }
    const Stmt* assign(std::string_view to, const Expr* value, Span at) {
        return add(Stmt{
            .kind = Stmt::Kind::Assign, .span = at, .name_span = at, .op = "=", .target = name(to), .value = value});
    }
    const Expr* none_of(const Flags& flags) {
        const Expr* any = nullptr;
        for (const std::string_view flag : flags) {
            const Expr* each = name(flag);
            any = any ? add(Expr{.kind = Expr::Kind::Binary, .text = "||", .args = {any, each}}) : each;
        }
        return add(Expr{.kind = Expr::Kind::Unary, .text = "!", .args = {any}});
    }

    // --- jumps
    // From now on, until it is destroyed, something follows in every region.
    class Inside {
    public:
        explicit Inside(std::vector<Region>& regions) : regions_(regions) {
            for (Region& each : regions) before_.push_back(std::exchange(each.is_at_end, false));
        }
        ~Inside() {
            for (std::size_t i = 0; i < before_.size(); ++i) regions_[i].is_at_end = before_[i];
        }
        Inside(const Inside&) = delete;

    private:
        std::vector<Region>& regions_;
        std::vector<bool> before_{};
    };

    void leave(Region& region, Statements& into, Flags& set, Span at, std::string_view word) {
        if (region.is_at_end) return;
        if (region.flag.empty()) region.flag = fresh(word);
        into.push_back(assign(region.flag, boolean(true), at));
        set.insert(region.flag);
        // A loop inside of the region ends, too.
        for (std::size_t i = static_cast<std::size_t>(&region - regions_.data()) + 1; i < regions_.size(); ++i) {
            if (regions_[i].is_loop) regions_[i].ends.insert(region.flag);
        }
    }

    void jump(const Stmt& stmt, Statements& into, Flags& set) {
        if (stmt.kind == Stmt::Kind::Return) {
            if (keeps_returns_) {
                into.push_back(&stmt);
                return;
            }
            if (!result_.empty() && stmt.value) into.push_back(assign(result_, stmt.value, stmt.span));
            leave(regions_.front(), into, set, stmt.span, "done");
            return;
        }
        const bool is_break = stmt.kind == Stmt::Kind::Break;
        for (std::size_t i = regions_.size(); i-- > 1;) {
            Region& region = regions_[i];
            if (!region.is_loop && !(is_break && region.is_switch)) continue;
            if (is_break && region.is_loop) {
                if (region.running.empty()) region.running = fresh("running");
                into.push_back(assign(region.running, boolean(false), stmt.span));
            }
            leave(region, into, set, stmt.span, region.is_switch ? "left" : "skipped");
            return;
        }
        into.push_back(&stmt);  // emission reports that there is nothing to leave
    }

    // What follows a statement that may have jumped.
    void guard(const Flags& flags, Statements rest, Statements& into, Flags& set) {
        set.insert(flags.begin(), flags.end());
        if (rest.empty()) return;
        if (keeps_returns_ && contains(rest, Stmt::Kind::Return)) is_stuck_ = true;
        Stmt made{.kind = Stmt::Kind::If, .span = rest.front()->span, .name_span = rest.front()->span};
        made.value = none_of(flags);
        made.body = process(rest, set);
        into.push_back(add(std::move(made)));
    }

    Statements process(const Statements& list, Flags& set) {
        if (depth_ >= kMaxNesting) {
            if (!is_too_deep_ && !list.empty())
                diagnostics_.report(Code::TooDeep, list.front()->span, kMaxNesting)
                    .note("code after a statement that may jump is nested one level deeper");
            is_too_deep_ = true;
            return {};
        }
        ++depth_;
        Statements made = without_jumps(list, set);
        --depth_;
        return made;
    }

    Statements without_jumps(const Statements& list, Flags& set) {
        Statements made;
        for (std::size_t i = 0; i < list.size(); ++i) {
            const Stmt& stmt = *list[i];
            Statements rest(list.begin() + static_cast<std::ptrdiff_t>(i) + 1, list.end());
            switch (stmt.kind) {
                case Stmt::Kind::Return:
                case Stmt::Kind::Break:
                case Stmt::Kind::Continue: jump(stmt, made, set); return made;
                case Stmt::Kind::If:
                    if (branch(stmt, rest, made, set)) return made;
                    break;
                case Stmt::Kind::Block:
                case Stmt::Kind::Loop: {
                    Flags own;
                    const bool is_last = rest.empty();
                    if (stmt.kind == Stmt::Kind::Loop)
                        loop(stmt, made, own);
                    else
                        block(stmt, is_last, made, own);
                    if (keeps_returns_ && !is_last && contains(stmt.body, Stmt::Kind::Return) &&
                        !always_leaves({&stmt}))
                        is_stuck_ = true;
                    if (!own.empty()) {
                        guard(own, std::move(rest), made, set);
                        return made;
                    }
                    break;
                }
                case Stmt::Kind::Declare:
                case Stmt::Kind::Assign:
                case Stmt::Kind::For:
                case Stmt::Kind::Discard:
                case Stmt::Kind::Evaluate: made.push_back(&stmt); break;
            }
        }
        return made;
    }

    // True: what follows has been taken, too.
    bool branch(const Stmt& stmt, const Statements& rest, Statements& into, Flags& set) {
        const bool body_may = may_leave(stmt.body), other_may = may_leave(stmt.alternative);
        const bool body_does = always_leaves(stmt.body), other_does = always_leaves(stmt.alternative);
        Stmt made = stmt;
        const auto with_rest = [&](const Statements& list) {
            Statements all = rest;
            // Names of the branch are not visible in the statements that follow it.
            if (!list.empty())
                all.insert(all.begin(), add(Stmt{.kind = Stmt::Kind::Block, .span = stmt.span, .body = list}));
            return all;
        };
        Flags own;
        if (rest.empty() || (body_does && other_does)) {
            made.body = process(stmt.body, own);
            made.alternative = process(stmt.alternative, own);
        } else if (body_does && !other_may) {
            made.body = process(stmt.body, own);
            made.alternative = process(with_rest(stmt.alternative), own);
        } else if (other_does && !body_may) {
            made.body = process(with_rest(stmt.body), own);
            made.alternative = process(stmt.alternative, own);
        } else {
            {
                const Inside inside(regions_);
                made.body = process(stmt.body, own);
                made.alternative = process(stmt.alternative, own);
            }
            if (keeps_returns_ &&
                (contains(stmt.body, Stmt::Kind::Return) || contains(stmt.alternative, Stmt::Kind::Return)))
                is_stuck_ = true;
            into.push_back(add(std::move(made)));
            if (own.empty()) return false;
            guard(own, rest, into, set);
            return true;
        }
        set.insert(own.begin(), own.end());
        into.push_back(add(std::move(made)));
        return true;
    }

    void block(const Stmt& stmt, bool is_last, Statements& into, Flags& set) {
        std::optional<Inside> inside;
        if (!is_last) inside.emplace(regions_);
        if (stmt.takes_break) regions_.push_back({.is_switch = true});
        Stmt made = stmt;
        made.body = process(stmt.body, set);
        if (stmt.takes_break) {
            const std::string_view flag = regions_.back().flag;
            regions_.pop_back();
            set.erase(flag);
            if (!flag.empty()) made.body.insert(made.body.begin(), declare("bool", flag, boolean(false)));
        }
        into.push_back(add(std::move(made)));
    }

    void loop(const Stmt& stmt, Statements& into, Flags& set) {
        const Inside inside(regions_);
        if (keeps_returns_ && contains(stmt.body, Stmt::Kind::Return)) is_stuck_ = true;
        regions_.push_back({.is_loop = true});
        Stmt made = stmt;
        Flags own;
        made.body = process(stmt.body, own);
        const Region region = regions_.back();
        regions_.pop_back();
        own.erase(region.flag);
        if (!region.flag.empty()) made.body.insert(made.body.begin(), declare("bool", region.flag, boolean(false)));
        set.insert(own.begin(), own.end());
        if (region.ends.empty() && region.running.empty()) {
            into.push_back(add(std::move(made)));
            return;
        }
        const Expr* goes_on = region.running.empty() ? none_of(region.ends) : name(region.running);
        if (!region.running.empty() && !region.ends.empty())
            goes_on = add(Expr{.kind = Expr::Kind::Binary, .text = "&&", .args = {goes_on, none_of(region.ends)}});
        made.limit = goes_on;
        if (!made.step.empty()) {
            Stmt step{.kind = Stmt::Kind::If, .span = stmt.span, .name_span = stmt.span, .value = goes_on};
            step.body = std::move(made.step);
            made.step = {add(std::move(step))};
        }
        if (region.running.empty()) {
            into.push_back(add(std::move(made)));
            return;
        }
        Stmt around{.kind = Stmt::Kind::Block, .span = stmt.span};
        around.body = {declare("bool", region.running, boolean(true)), add(std::move(made))};
        into.push_back(add(std::move(around)));
    }

    FunctionDecl& function_;
    Ast& ast_;
    Diagnostics& diagnostics_;
    int depth_ = 0;
    const bool keeps_returns_;
    bool is_stuck_ = false, is_too_deep_ = false;
    std::string_view result_{};
    Flags names_{};
    std::vector<Region> regions_{};
};

}  // namespace

bool always_leaves(const Statements& list) {
    return std::any_of(list.begin(), list.end(), [](const Stmt* s) {
        switch (s->kind) {
            case Stmt::Kind::Return:
            case Stmt::Kind::Break:
            case Stmt::Kind::Continue: return true;
            case Stmt::Kind::If: return always_leaves(s->body) && always_leaves(s->alternative);
            case Stmt::Kind::Block:
                // A break would leave the switch alone.
                return always_leaves(s->body) && !(s->takes_break && contains(s->body, Stmt::Kind::Break));
            case Stmt::Kind::Declare:
            case Stmt::Kind::Assign:
            case Stmt::Kind::For:
            case Stmt::Kind::Discard:
            case Stmt::Kind::Evaluate:
            case Stmt::Kind::Loop: return false;
        }
        return false;
    });
}

void remove_jumps(FunctionDecl& function, Ast& ast, Diagnostics& diagnostics) {
    const bool has_loops = contains(function.body, Stmt::Kind::Loop);
    if (!has_loops && !may_leave(function.body) && !contains(function.body, Stmt::Kind::Break)) return;
    const bool has_value = function.result.name != "void";
    if (has_value && Remover(function, ast, diagnostics, true).run()) return;
    Remover(function, ast, diagnostics, false).run();
}

}  // namespace patina::nodelang
