"""What the tests share: one that asks for `real` runs in both real types."""

import pytest
from golden import REALS


@pytest.fixture(params=REALS, ids=lambda real: real.name)
def real(request):
    return request.param
