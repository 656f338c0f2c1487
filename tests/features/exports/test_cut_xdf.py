"""An XDF file that is cut: pyxdf reads every whole chunk before the cut.

Two exceptions are pyxdf's: a cut within the tag of a chunk is an error; after a cut within the values of the last
sample of a chunk, pyxdf returns this sample, with bytes of the one before it.
"""

import struct
from pathlib import Path
from typing import NamedTuple

import numpy as np
import pytest
import pyxdf
from exported_clinic import RUN, make_clinic

from app.features.exports.xdf_form import SAMPLES, STREAM_HEADER, write_xdf
from app.recording.groups import read_in_groups

MAGIC = 4  # bytes: "XDF:"
LENGTH, TAG = 9, 2  # bytes of a chunk before its tag, and of the tag
SAMPLES_BEGIN = 20  # byte of a chunk with samples at which the first one begins
STAMP = 9  # bytes of a sample before its values
# Places of a cut within a chunk: in its length, its tag, the number of its stream, its number of samples and its first.
WITHIN = (0, 1, 4, 8, 9, 10, 11, 13, 15, 16, 19, 20, 24, 28, 29, 40)


class Chunk(NamedTuple):
    start: int  # the first byte
    end: int  # the byte after it
    tag: int
    stream: int
    samples: int

    def all_stamps(self) -> int:
        """Return how many bytes of the chunk hold all its time stamps; without samples, all its bytes."""
        if not self.samples:
            return self.end - self.start
        sample = (self.end - self.start - SAMPLES_BEGIN) // self.samples
        return self.end - self.start - sample + STAMP


class Written(NamedTuple):
    content: bytes
    chunks: list[Chunk]
    sample_rate: float


@pytest.fixture(scope="module")
def written(tmp_path_factory: pytest.TempPathFactory) -> Written:
    """Return the bytes of an export of 4 s, and its chunks."""
    folder = tmp_path_factory.mktemp("clinic")
    run = read_in_groups(make_clinic(folder).runs / RUN)
    (file,) = write_xdf(run, {"patient": "P-1"}, folder, "run")
    content = file.read_bytes()
    chunks, start = [], MAGIC
    while start < len(content):
        size, tag = struct.unpack_from("<xQH", content, start)
        stream, samples = struct.unpack_from("<IxI", content, start + LENGTH + TAG)
        chunks.append(Chunk(start, start + LENGTH + size, tag, stream, samples if tag == SAMPLES else 0))
        start = chunks[-1].end
    return Written(content, chunks, float(run.meta["sample_rate"]))


def loaded(content: bytes, folder: Path) -> dict[int, tuple[np.ndarray, np.ndarray]]:
    """Return the time stamps and the values of each stream, as pyxdf reads them."""
    file = folder / "cut.xdf"
    file.write_bytes(content)
    streams, _ = pyxdf.load_xdf(file, dejitter_timestamps=False, synchronize_clocks=False)
    return {
        stream["info"]["stream_id"]: (np.asarray(stream["time_stamps"]), np.asarray(stream["time_series"]))
        for stream in streams
    }


def test_every_whole_chunk_before_a_cut_is_read(written: Written, tmp_path: Path) -> None:
    whole = loaded(written.content, tmp_path)
    last_header = max(chunk.end for chunk in written.chunks if chunk.tag == STREAM_HEADER)
    after_headers = [chunk for chunk in written.chunks if chunk.start >= last_header]
    read = 0
    for chunk in after_headers:
        size = chunk.end - chunk.start
        last = chunk.all_stamps()
        for within in {*(place for place in WITHIN if place < size), size // 2, last - 1, last, size - 1} - {size}:
            cut = written.content[: chunk.start + within]
            if LENGTH <= within < LENGTH + TAG:  # pyxdf reads a length, and then takes the tag to be there
                with pytest.raises(struct.error):
                    loaded(cut, tmp_path)
                continue
            found = loaded(cut, tmp_path)
            for stream, (times, values) in whole.items():
                count = sum(one.samples for one in written.chunks if one.stream == stream and one.end <= len(cut))
                more = chunk.samples if chunk.stream == stream and within >= last else 0
                np.testing.assert_array_equal(found[stream][0], times[: count + more])
                right = count + max(more - 1, 0)
                np.testing.assert_array_equal(found[stream][1][:right], values[:right])
            read += 1
    assert read > 10 * len(after_headers)


def test_a_chunk_has_at_most_a_second_of_samples(written: Written) -> None:
    chunks = [chunk for chunk in written.chunks if chunk.tag == SAMPLES]
    assert max(chunk.samples for chunk in chunks) == written.sample_rate
    assert len(chunks) >= 4 * len({chunk.stream for chunk in chunks})


def test_before_the_first_sample_a_cut_file_is_refused_or_empty(written: Written, tmp_path: Path) -> None:
    first = min(chunk.start for chunk in written.chunks if chunk.tag == SAMPLES)
    for end in range(MAGIC, first, 7):
        try:
            found = loaded(written.content[:end], tmp_path)
        except (struct.error, SyntaxError):  # xml's ParseError is a SyntaxError
            continue
        assert all(len(times) == 0 for times, _ in found.values())
