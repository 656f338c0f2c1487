"""Keeps the exception that ends the start of the application: uvicorn only logs it."""

from starlette.types import ASGIApp, Receive, Scope, Send


class KeepsFailure:
    """An application in front of another one; `failure` is what ended the other one's start or end."""

    def __init__(self, app: ASGIApp) -> None:
        self._app = app
        self.failure: Exception | None = None

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Run the application."""
        try:
            await self._app(scope, receive, send)
        except Exception as error:
            if scope["type"] == "lifespan":
                self.failure = error
            raise
