"""Do the examples of the docstrings print what they say?"""

import doctest
import inspect
from pathlib import Path

import pytest

import atraj
import atraj.claraty
import atraj.f32

PAGES = {Path(__file__).parents[2] / "docs" / name: programs for name, programs in [("for-python.md", 5), ("path.md", 1)]}
MODULES = [atraj, atraj.f32, atraj.claraty]


def documented():
    """Names and docstrings with examples, of the modules and all that they export."""
    for module in MODULES:
        yield module.__name__, module.__doc__
        for name in module.__all__:
            item = getattr(module, name)
            yield f"{module.__name__}.{name}", inspect.getdoc(item)
            members = vars(item) if inspect.isclass(item) else {}
            for member in members:
                yield f"{module.__name__}.{name}.{member}", inspect.getdoc(getattr(item, member))


# The classes of both real types have the same docstrings, whose examples use `atraj`.
EXAMPLES = {name: text for name, text in documented() if text and ">>>" in text and not name.startswith("atraj.f32.")}


@pytest.mark.parametrize("name", EXAMPLES)
def test_examples(name):
    test = doctest.DocTestParser().get_doctest(EXAMPLES[name], {}, name, None, None)
    failed, attempted = doctest.DocTestRunner().run(test)
    assert attempted > 0 and failed == 0


@pytest.mark.parametrize("page", PAGES)
def test_the_page_runs(page):
    blocks = page.read_text().split("```python\n")[1:]
    assert len(blocks) == PAGES[page]
    for block in blocks:
        exec(block.split("```")[0], {})


def test_everything_public_is_documented():
    for module in MODULES:
        for name in module.__all__:
            assert inspect.getdoc(getattr(module, name)), name
    for name in [name for name in atraj.__all__ if inspect.isclass(getattr(atraj, name))]:
        members = [member for member in vars(getattr(atraj, name)) if not member.startswith("_")]
        for member in members:
            assert getattr(getattr(atraj, name), member).__doc__, (name, member)
