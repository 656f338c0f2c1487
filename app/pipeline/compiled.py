"""Whether the middle of the program runs compiled, or as plain Python: the numbers are equal, the speed is not."""

from app.pipeline import chain

IS_COMPILED = not chain.__file__.endswith(".py")
