"""Files: read without trust, written whole or not at all."""

from motes.files.inert import write_csv
from motes.files.together import settle, together
from motes.files.writing import check_writable, replacing, write_json, write_text

__all__ = ["check_writable", "replacing", "settle", "together", "write_csv", "write_json", "write_text"]
