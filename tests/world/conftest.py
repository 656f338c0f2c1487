"""Where a test's drawings are saved."""

import pytest


@pytest.fixture
def save(tmp_path):
    def write(document, name="hall.dxf"):
        file = tmp_path / name
        document.saveas(file)
        return file

    return write
