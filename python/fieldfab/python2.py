"""Python 2 as a dialect: compiles its text for the Python that runs, by rewriting tokens, then the syntax tree.

    from fieldfab import python2, python2_names
    names = {"__builtins__": python2_names.builtins_of_python2(exec)}
    exec(python2.compiled("half = 7 / 2", "design.ko"), names)    # names["half"] is 3

Tokens are rewritten where Python 3 refuses the grammar (print, exec, `except E, e`, backquotes, 0777, tuples as
parameters), the tree where it accepts the text with another meaning (division, dict.keys(), str.decode). Rewriting
keeps every line on its number.
Not covered: names of list comprehensions stay inside them, and str holds characters, not bytes.
"""

from __future__ import annotations

import ast
import re
import warnings

from . import python2_names as names

TOKEN = re.compile(r"""
    (?P<string>(?i:[ub]?r?)(?:'''(?:[^\\]|\\.)*?'''|\"\"\"(?:[^\\]|\\.)*?\"\"\"
                           |'(?:[^\\\n']|\\.)*'|"(?:[^\\\n"]|\\.)*"))
  | (?P<comment>\#[^\n]*)
  | (?P<join>\\\n)
  | (?P<newline>\n)
  | (?P<space>[ \t\f]+)
  | (?P<number>0[xX][0-9a-fA-F]+[lL]?|0[bB][01]+[lL]?|0[oO][0-7]+[lL]?|(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?[jJlL]?)
  | (?P<name>[^\W\d]\w*)
  | (?P<operator><>|>>=|<<=|\*\*=|//=|>>|<<|[-+*/%&|^=<>!]=|\*\*|//|[^\n])
""", re.VERBOSE | re.DOTALL)

OPENING, CLOSING = {"(", "[", "{"}, {")", "]", "}"}
BLANK = {"space", "comment", "join", "newline"}
COMPOUND = {"if", "elif", "else", "while", "for", "try", "except", "finally", "with", "def", "class"}  # ':' ends them
NEW_KEYWORDS = {"async", "await", "nonlocal"}
TAB = 8  # columns, as in Python 2
PARAMETER = "_tuple_parameter_"


class Token:
    def __init__(self, kind, text, line):
        self.kind, self.text, self.line = kind, text, line


def _tokens(text):
    line, at, found = 1, 0, []
    while at < len(text):
        match = TOKEN.match(text, at)
        found.append(Token(match.lastgroup, match.group(), line))
        line += match.group().count("\n")
        at = match.end()
    return found


def _string(text):
    r"""Returns a string literal without the prefixes b and u. A plain one has no Unicode escapes: \u stands for two
    characters.
    """
    quote = min(at for at in (text.find("'"), text.find('"')) if at >= 0)
    prefix, body = text[:quote].lower(), text[quote:]
    if "u" not in prefix and "r" not in prefix:
        body = re.sub(r"\\(.)", lambda m: "\\" + m.group() if m.group(1) in "uUN" else m.group(), body, flags=re.DOTALL)
    return ("r" if "r" in prefix else "") + body


def _number(text):
    text = text.rstrip("lL")
    return "0o" + text[1:] if re.fullmatch(r"0[0-7]+", text) else text


class _Statement:
    """The tokens of a simple statement, or of a compound one up to its colon."""

    def __init__(self, tokens):
        self.tokens = tokens
        self.words = [i for i, token in enumerate(tokens) if token.kind not in BLANK]

    def first(self):
        return self.tokens[self.words[0]].text if self.words else ""

    def top(self, text):
        """Returns the indices of a token outside all brackets and after the first word."""
        depth, found = 0, []
        for i in self.words[1:]:
            here = self.tokens[i].text
            depth += (here in OPENING) - (here in CLOSING)
            if depth == 0 and here == text:
                found.append(i)
        return found

    def call(self, head, first, last):
        """Turns the tokens from `first` to `last` into a call: replaces the tokens before them by `head` and a
        parenthesis.
        """
        self.tokens[self.words[0]].text = head + "("
        for i in range(self.words[0] + 1, first):
            if self.tokens[i].kind not in BLANK:
                self.tokens[i].text = ""
        self.tokens[last].text += ")"


def _print(statement):
    """Rewrites print a, b / print >>f, a / print a, (a trailing comma suppresses the line end)."""
    tokens, words = statement.tokens, statement.words
    if len(words) == 1:
        tokens[words[0]].text = f"{names.PRINT}(None, False)"
        return
    comma = tokens[words[-1]].text == ","
    if comma:
        tokens[words[-1]].text = ""
    if tokens[words[1]].text == ">>":
        commas = statement.top(",")
        if commas and commas[0] != words[-1]:
            tokens[commas[0]].text = f", {comma}, "
        else:
            tokens[words[-1]].text += ", False"
        statement.call(names.PRINT, words[2], words[-1])
    else:
        statement.call(f"{names.PRINT}(None, {comma}, ", words[1], words[-1])
        tokens[words[0]].text = tokens[words[0]].text[:-1]


def _exec(statement):
    """Rewrites exec code / exec code in globals, locals."""
    tokens, words = statement.tokens, statement.words
    inside = statement.top("in")
    for i in inside[:1]:
        tokens[i].text = ","
    if not inside:
        tokens[words[-1]].text += ", globals(), locals()"
    statement.call(names.EXEC, words[1], words[-1])


def _raise(statement):
    """Rewrites raise E, value / raise E, value, traceback."""
    if statement.top(","):
        statement.call(f"raise {names.ERROR}", statement.words[1], statement.words[-1])


def _except(statement):
    """Rewrites except E, e:"""
    for i in statement.top(",")[-1:]:
        statement.tokens[i].text = " as "


REWRITTEN = {"print": _print, "exec": _exec, "raise": _raise, "except": _except}


def _statements(tokens):
    """Returns the tokens grouped by statement."""
    current, depth, lambdas = [], 0, 0
    head = ""
    for token in tokens:
        current.append(token)
        if token.kind not in BLANK and not head:
            head = token.text
        depth += (token.text in OPENING) - (token.text in CLOSING)
        if depth == 0:
            lambdas += token.text == "lambda"
            ends = token.kind == "newline" or token.text == ";"
            if token.text == ":":
                ends = not lambdas and head in COMPOUND
                lambdas = max(0, lambdas - 1)
            if ends:
                yield _Statement(current)
                current, lambdas, head = [], 0, ""
    yield _Statement(current)


def _ended(statement):
    """Returns a statement without its ';', ':' or line end, which keeps its place."""
    words = statement.words
    if words and statement.tokens[words[-1]].text in (";", ":"):
        return _Statement(statement.tokens[:words[-1]])
    return statement


def _tuple_parameters(tokens, taken):
    """Replaces tuples among parameters by names; `taken` receives the tuples."""
    words = [i for i, token in enumerate(tokens) if token.kind not in BLANK]
    lists = []  # of the parameter lists that are open: the depth inside them
    depth, previous, waits, skip = 0, "", False, -1
    for i in words:
        text = tokens[i].text
        if i < skip:
            continue
        if lists and depth == lists[-1] and text == "(" and previous in ("(", ",", "lambda"):
            end, inner = i, 0
            while end < len(tokens):
                inner += (tokens[end].text in OPENING) - (tokens[end].text in CLOSING)
                if inner == 0:
                    break
                end += 1
            name = f"{PARAMETER}{len(taken)}"
            taken[name] = "".join(token.text for token in tokens[i:end + 1] if token.kind not in ("comment", "newline"))
            for token in tokens[i:end + 1]:
                token.text = token.text if token.kind == "newline" else ""
            tokens[i].text, skip, previous = name, end + 1, name
            continue
        depth += (text in OPENING) - (text in CLOSING)
        if text == "lambda":
            lists.append(depth)
        elif waits and text == "(":
            lists.append(depth)
            waits = False
        elif lists and (depth < lists[-1] or (text == ":" and depth == lists[-1])):
            lists.pop()
        waits = waits or text == "def"
        previous = text


def rewritten(text):
    """Returns the text in Python 3's grammar with unchanged line numbers, and its tuple parameters by name."""
    text = text.replace("\r\n", "\n").replace("\r", "\n")
    tokens = _tokens(text if text.endswith("\n") else text + "\n")
    names_only = [token.text for token in tokens if token.kind == "name"]
    prints = "print_function" not in names_only
    line_starts, depth, ticks = True, 0, 0
    for token in tokens:
        depth += (token.text in OPENING) - (token.text in CLOSING)
        if token.kind == "space" and line_starts:
            token.text = token.text.replace("\f", "").expandtabs(TAB)
        line_starts = token.kind == "newline" and depth == 0
        if token.kind == "string":
            token.text = _string(token.text)
        elif token.kind == "number":
            token.text = _number(token.text)
        elif token.kind == "name" and token.text in NEW_KEYWORDS:
            token.text += "_"
        elif token.text == "<>":
            token.text = "!="
        elif token.text == "`":
            ticks += 1
            token.text = "repr(" if ticks % 2 else ") "  # later passes count neither as a bracket
    taken = {}
    _tuple_parameters(tokens, taken)
    for statement in _statements(tokens):
        statement = _ended(statement)
        if statement.first() in REWRITTEN and (prints or statement.first() != "print"):
            REWRITTEN[statement.first()](statement)
    return "".join(token.text for token in tokens), taken


def _name(word):
    return ast.Name(word, ast.Load())


def _call(word, *arguments):
    return ast.Call(_name(word), list(arguments), [])


def _at(node, made):
    """Returns the node `made` at the position of `node`."""
    return ast.fix_missing_locations(ast.copy_location(made, node))


class _Tree(ast.NodeTransformer):
    """Gives a syntax tree of Python 3 the meaning of Python 2."""

    def __init__(self, divides, taken):
        self.divides, self.taken = divides, taken

    def visit_BinOp(self, node):
        self.generic_visit(node)
        if not self.divides or not isinstance(node.op, ast.Div):
            return node
        return _at(node, _call(names.DIVIDE, node.left, node.right))

    def visit_Compare(self, node):
        """Orders values of different types; leaves chained comparisons alone."""
        self.generic_visit(node)
        operation = type(node.ops[0]).__name__
        if len(node.ops) > 1 or operation not in names.ORDERS:
            return node
        return _at(node, _call(names.COMPARE, node.left, ast.Constant(operation), node.comparators[0]))

    def visit_AugAssign(self, node):
        self.generic_visit(node)
        if not self.divides or not isinstance(node.op, ast.Div):
            return node
        target = node.target
        if isinstance(target, ast.Name):
            return _at(node, ast.Assign([target], _call(names.DIVIDE, _name(target.id), node.value)))
        if isinstance(target, ast.Attribute):
            return _at(node, ast.Expr(_call(names.DIVIDE_ATTRIBUTE, target.value, ast.Constant(target.attr),
                                            node.value)))
        return _at(node, ast.Expr(_call(names.DIVIDE_ITEM, target.value, target.slice, node.value)))

    def visit_Attribute(self, node):
        self.generic_visit(node)
        if isinstance(node.ctx, ast.Load) and node.attr in names.ATTRIBUTES:
            return _at(node, _call(names.ATTRIBUTE, node.value, ast.Constant(node.attr)))
        return node

    def visit_ExceptHandler(self, node):
        """Keeps the name of an exception after the handler."""
        self.generic_visit(node)
        if node.name:
            node.body.insert(0, ast.Assign([ast.Name(node.name, ast.Store())], _name("_caught")))
            node.name = "_caught"
        return node

    def visit_ClassDef(self, node):
        """Renames next, __nonzero__ and __div__."""
        self.generic_visit(node)
        made = {each.name for each in node.body if isinstance(each, ast.FunctionDef)}
        node.body += [ast.Assign([ast.Name(new, ast.Store())], _name(old)) for old, new in names.METHODS.items()
                      if old in made]
        return node

    def visit_FunctionDef(self, node):
        self.generic_visit(node)
        unpacked = [ast.Assign([self._target(each)], _name(each)) for each in self._tuples(node)]
        at = 1 if unpacked and ast.get_docstring(node) is not None else 0
        node.body[at:at] = unpacked
        return node

    def visit_Lambda(self, node):
        """Rewrites `lambda (a, b): c` as `lambda t: [c for (a, b) in [t]][0]`."""
        self.generic_visit(node)
        for each in reversed(self._tuples(node)):
            loop = ast.comprehension(self._target(each), ast.List([_name(each)], ast.Load()), [], 0)
            node.body = ast.Subscript(ast.ListComp(node.body, [loop]), ast.Constant(0), ast.Load())
        return node

    def _tuples(self, node):
        return [each.arg for each in node.args.args if each.arg in self.taken]

    def _target(self, name):
        (assignment,) = ast.parse(self.taken[name] + " = 0").body
        assert isinstance(assignment, ast.Assign)
        return assignment.targets[0]


def compiled(text, filename):
    """Compiles Python 2 text. Raises SyntaxError with the line numbers of the text."""
    changed, taken = rewritten(text)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # of escapes such as "\d", valid in Python 2
        tree = ast.parse(changed, filename)
        futures = {each.name for node in tree.body if isinstance(node, ast.ImportFrom) and node.module == "__future__"
                   for each in node.names}
        tree = _Tree("division" not in futures, taken).visit(tree)
        return compile(ast.fix_missing_locations(tree), filename, "exec", dont_inherit=True)


def loop_names(text):
    """Returns the variables of for loops in valid Python 2 text."""
    tree = ast.parse(rewritten(text)[0])
    targets = [node.target for node in ast.walk(tree) if isinstance(node, ast.For)]
    return {each.id for target in targets for each in ast.walk(target) if isinstance(each, ast.Name)}


def read(path):
    """Returns the text of a file, decoded by its coding line, otherwise as UTF-8, otherwise as Latin 1."""
    with open(path, "rb") as file:
        data = file.read()
    named = re.match(rb"(?:[^\n]*\n)?[ \t\f]*#[^\n]*coding[:=][ \t]*([-\w.]+)", data)
    for coding in ([named.group(1).decode("ascii")] if named else []) + ["utf-8-sig", "latin-1"]:
        try:
            return data.decode(coding)
        except (UnicodeDecodeError, LookupError):
            continue
