"""Shared: the docstrings of the module in its stubs, and the API page that is made of both."""

import ast
import inspect
import re
import textwrap
from pathlib import Path

import atraj
import atraj.claraty

ROOT = Path(__file__).parents[2]
STUBS = {
    atraj: ROOT / "python/atraj/__init__.pyi",
    atraj.claraty: ROOT / "python/atraj/claraty.pyi",
}
VALUES = ROOT / "python/atraj/values.py"
PAGE = ROOT / "docs/python-api.md"
INTRODUCTION = """# The Python API
This page is made of the docstrings: `make python-update` writes it and the stubs, and a test compares both with the module. [For Python](for-python.md) is the
guide. `atraj.f32` has the classes of `atraj` in binary32; what goes into them and comes out of them, `Limits` and `State` for example, is in `atraj` alone.
"""


def definitions(nodes):
    return [node for node in nodes if isinstance(node, ast.ClassDef | ast.FunctionDef)]


def is_decorated(node, name):
    return any(isinstance(item, ast.Name) and item.id == name for item in node.decorator_list)


def members(node):
    """What a class declares for its users, each overload once."""
    own = {}
    for member in definitions(node.body):
        if not member.name.startswith("_"):
            own.setdefault(member.name, member)
    return list(own.values())


def with_docstrings(module, stub):
    """The text of a stub with the docstrings of the module."""
    tree = ast.parse(stub)
    lines = stub.splitlines(keepends=True)
    starts = [0]
    for line in lines:
        starts.append(starts[-1] + len(line.encode()))
    text, edits = stub.encode(), []

    def document(node, text_of_doc, keeps_body):
        """Sets the docstring of a class or function."""
        indent = " " * (node.col_offset + 4)
        doc = textwrap.indent(f'"""{text_of_doc}"""', indent).replace(f"\n{indent}\n", "\n\n") + "\n"
        first, *others = node.body
        is_filler = isinstance(first, ast.Expr) and isinstance(first.value, ast.Constant)
        begin = starts[first.lineno - 1] + first.col_offset
        if not is_filler and first.decorator_list:
            decorator = first.decorator_list[0]
            begin = starts[decorator.lineno - 1] + decorator.col_offset - 1
        end = begin
        if is_filler:
            end = starts[first.end_lineno - 1] + first.end_col_offset
        header = len(text[:begin].rstrip())
        rest = b"\n" if not (keeps_body and (others or not is_filler)) else b"\n" + indent.encode()
        after = end + len(text[end:]) - len(text[end:].lstrip()) if rest != b"\n" else end
        ending = doc.rstrip("\n").encode() + (rest if rest != b"\n" else b"")
        edits.append((header, after, b"\n" + ending))

    for node in definitions(tree.body):
        item = getattr(module, node.name)
        document(node, inspect.getdoc(item), isinstance(node, ast.ClassDef))
        if isinstance(node, ast.ClassDef):
            for member in members(node):
                document(member, inspect.getdoc(getattr(item, member.name)), False)
    for begin, end, new in sorted(edits, reverse=True):
        text = text[:begin] + new + text[end:]
    return text.decode()


def arguments(node, of_class=False):
    """The arguments of a function as a user writes them."""
    given = node.args
    names = [argument.arg for argument in given.args]
    defaults = [None] * (len(names) - len(given.defaults)) + given.defaults
    positional = list(zip(names, defaults))
    if positional and positional[0][0] in ("self", "cls"):
        positional.pop(0)
    shown = [name if default is None else f"{name}={ast.unparse(default)}" for name, default in positional]
    if given.kwonlyargs:
        shown.append("*")
        for argument, default in zip(given.kwonlyargs, given.kw_defaults):
            shown.append(argument.arg if default is None else f"{argument.arg}={ast.unparse(default)}")
    return f"({', '.join(shown)})"


def fields(item):
    """The arguments of a named tuple."""
    given = inspect.signature(item)
    plain = [parameter.replace(annotation=inspect.Parameter.empty) for parameter in given.parameters.values()]
    return str(given.replace(parameters=plain, return_annotation=inspect.Signature.empty))


def sentences(node):
    """What `values.py` says behind each member of a set."""
    pairs = [(member, said) for member, said in zip(node.body, node.body[1:]) if isinstance(member, ast.Assign)]
    return {member.targets[0].id: f": {said.value.value}" for member, said in pairs if isinstance(said, ast.Expr)}


def markdown(doc):
    """A docstring whose examples are fenced."""
    parts = []
    for part in re.split(r"\n\n", doc):
        lines = part.splitlines()
        begin = next((k for k, line in enumerate(lines) if line.startswith(">>>")), len(lines))
        if lines[:begin]:
            parts.append("\n".join(lines[:begin]))
        if lines[begin:]:
            parts.append("\n".join(["```pycon", *lines[begin:], "```"]))
    return "\n\n".join(parts)


def described(name, signature, doc):
    return f"{name}\n```python\n{signature}\n```\n{markdown(doc)}\n"


def described_members(item, node):
    """The members that a class declares; a named tuple behind `if` declares none."""
    for member in members(node) if node else []:
        of = f"{item.__name__}.{member.name}"
        signature = of if is_decorated(member, "property") else of + arguments(member)
        yield described(f"#### {of}", signature, inspect.getdoc(getattr(item, member.name)))


def page():
    """The API page."""
    texts = [INTRODUCTION]
    values = {node.name: node for node in definitions(ast.parse(VALUES.read_text()).body)}
    for module, path in STUBS.items():
        tree = ast.parse(path.read_text())
        texts.append(f"## {module.__name__}\n{markdown(inspect.getdoc(module))}\n")
        declared = {node.name: node for node in definitions(tree.body)}
        for name in module.__all__:
            item, node = getattr(module, name), declared.get(name)
            full = f"{module.__name__}.{name}"
            if isinstance(node, ast.FunctionDef):
                texts.append(described(f"### {name}", full + arguments(node), inspect.getdoc(item)))
                continue
            if node is None:
                signature = full + (fields(item) if issubclass(item, tuple) else "")
                texts.append(described(f"### {name}", f"class {signature}", inspect.getdoc(item)))
                if hasattr(item, "__members__"):
                    said = sentences(values[name])
                    texts.append("".join(f"- `{name}.{member}` = {int(value)}{said.get(member, '')}\n" for member, value in item.__members__.items()))
                texts.extend(described_members(item, values.get(name)))
                continue
            new = [member for member in definitions(node.body) if member.name == "__new__"]
            base = f"({', '.join(map(ast.unparse, node.bases))})" if node.bases and not new else ""
            signature = f"class {full}{arguments(new[0]) if new else base}"
            texts.append(described(f"### {name}", signature, inspect.getdoc(item)))
            texts.extend(described_members(item, node))
    return "\n".join(texts)
