"""Files: read without trust, written whole or not at all."""

from motes.files.inert import write_csv
from motes.files.writing import replacing, write_text

__all__ = ["replacing", "write_csv", "write_text"]
