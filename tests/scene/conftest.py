"""The 3D servers of all roles, for each test."""

import pytest

from app.scene.role_servers import RoleServers


@pytest.fixture
def servers():
    with RoleServers() as started:
        yield started
