"""Contact sheets: many photographs, small, each above its name, on few pictures."""

from pathlib import Path

from PIL import Image, ImageDraw, ImageFont

WIDTH, HEIGHT = 1560, 1560  # px, at most
GAP, WORDS = 12, 20  # px
GROUND, INK = "#8a8f94", "#ffffff"


def save_sheets(files: list[Path], stem: Path) -> list[Path]:
    """Write the sheets of photographs of one size, as `stem`-1.png and so on; return their paths."""
    if not files:
        return []
    with Image.open(files[0]) as first:
        columns = 3 if first.width > first.height else 4
        width = min(first.width, (WIDTH - GAP) // columns - GAP)
        height = round(width * first.height / first.width)
    rows = max(1, (HEIGHT - GAP) // (height + WORDS + GAP))
    font = ImageFont.load_default(14)
    sheets = []
    for number, begin in enumerate(range(0, len(files), columns * rows), 1):
        part = files[begin : begin + columns * rows]
        used = -(-len(part) // columns)
        sheet = Image.new("RGB", (GAP + columns * (width + GAP), GAP + used * (height + WORDS + GAP)), GROUND)
        draw = ImageDraw.Draw(sheet)
        for place, file in enumerate(part):
            row, column = divmod(place, columns)
            left, top = GAP + column * (width + GAP), GAP + row * (height + WORDS + GAP)
            draw.text((left, top), file.stem, fill=INK, font=font)
            with Image.open(file) as picture:
                sheet.paste(picture.resize((width, height), Image.Resampling.LANCZOS), (left, top + WORDS))
        sheets.append(stem.with_name(f"{stem.name}-{number}.png"))
        sheet.save(sheets[-1])
    return sheets
