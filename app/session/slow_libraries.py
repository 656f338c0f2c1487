"""The slow libraries of measuring and learning: loaded before a chair may move, and not by the first look at a page."""

from importlib import import_module
from typing import Final

SLOW_LIBRARIES: Final = (
    *("scipy.optimize", "scipy.signal", "scipy.stats", "shapely", "sklearn.decomposition"),
    *("statsmodels.regression.linear_model", "statsmodels.stats.weightstats", "statsmodels.tools.eval_measures"),
)


def load_slow_libraries() -> None:
    """Load them all; the first call takes about a second, later ones nothing.

    A library that is loaded while a chair drives takes the interpreter from the thread that reads the screen's reports,
    and on a busy machine the gate would then stop the chair.
    """
    for name in SLOW_LIBRARIES:
        import_module(name)
