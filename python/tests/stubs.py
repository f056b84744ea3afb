"""Shared: the docstrings of the module in its stubs."""

import ast
import inspect
import textwrap
from pathlib import Path

import atraj
import atraj.claraty

ROOT = Path(__file__).parents[2]
STUBS = {
    atraj: ROOT / "python/atraj/__init__.pyi",
    atraj.claraty: ROOT / "python/atraj/claraty.pyi",
}


def definitions(nodes):
    return [node for node in nodes if isinstance(node, ast.ClassDef | ast.FunctionDef)]


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
