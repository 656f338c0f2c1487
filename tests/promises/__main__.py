"""`python -m promises`: writes docs/promises.md anew; `make page PAGE=promises`."""

from promises.page import PAGE, page

if __name__ == "__main__":
    PAGE.write_text(page(), encoding="utf-8")
