"""What the routes make for a first request is made before anybody can stop, and Stop is the first route."""

import gc

from starlette.routing import Match

from app.api import app as app_module
from app.api.app import create_app, prepare_routes
from app.api.routes import stop
from app.computing_process import ComputingProcess
from app.settings import Settings

FEW = 1000  # objects; the routes are 29,000, and to make them takes 0.15 s


def test_the_first_stop_makes_no_routes(tmp_path, monkeypatch):
    """Until they are made, a Stop took 0.15 s longer."""
    monkeypatch.setattr(app_module, "_routes_of_all_clinics", app_module._routes_of_all_clinics.__wrapped__)
    app = create_app(Settings(state=tmp_path), None, ComputingProcess())
    prepare_routes(app)
    gc.collect()
    before = len(gc.get_objects())
    request = {"type": "http", "method": "POST", "path": "/api/v1/control/stop", "root_path": "", "headers": []}
    found = [route.matches({**request})[0] for route in app.routes]
    assert Match.FULL in found
    assert len(gc.get_objects()) - before < FEW


def test_a_request_is_compared_with_stop_first():
    assert app_module.ROUTES[0] is stop
