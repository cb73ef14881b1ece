"""From LLVM's text to an object, as linkers know them: by this process, or by another that runs this file.

It imports nothing of Motes, so that a process which only compiles starts in a tenth of a second.
"""

from __future__ import annotations

import json
import sys
from typing import IO, Any

# Bytes of the number that is in front of a text and of an object, and the largest such number.
_LENGTH, _MOST = 8, 2**30


def machine_for(cpu: str, features: str) -> Any:
    """What LLVM knows of a processor; an engine takes one for itself."""
    from llvmlite import binding

    binding.initialize_native_target()
    binding.initialize_native_asmprinter()
    target = binding.Target.from_triple(binding.get_process_triple())
    reloc = "static" if target.name.startswith("x86") else "default"
    return target.create_target_machine(cpu, features, opt=3, reloc=reloc, codemodel="jitdefault", jit=True)


def optimised_for(text: str, machine: Any) -> Any:
    """LLVM's module of a text, as it is before it becomes an object."""
    from llvmlite import binding

    module = binding.parse_assembly(text)
    module.triple, module.data_layout = binding.get_process_triple(), str(machine.target_data)
    module.verify()
    tuning = binding.create_pipeline_tuning_options(3)
    tuning.loop_vectorization, tuning.slp_vectorization = True, False
    builder = binding.create_pass_builder(machine, tuning)
    builder.getModulePassManager().run(module, builder)
    return module


def object_of(text: str, cpu: str, features: str) -> bytes:
    """The object of a module."""
    machine = machine_for(cpu, features)
    return bytes(machine.emit_object(optimised_for(text, machine)))


def put(stream: IO[bytes], data: bytes) -> None:
    """Send bytes with their number in front."""
    stream.write(len(data).to_bytes(_LENGTH, "little") + data)
    stream.flush()


def take(stream: IO[bytes]) -> bytes:
    """The bytes that `put` sent.

    Raises
    ------
    EOFError
        Where the other end is gone, or says something else.
    """
    head = stream.read(_LENGTH)
    length = int.from_bytes(head, "little")
    data = stream.read(length) if len(head) == _LENGTH and length <= _MOST else b""
    if len(head) < _LENGTH or len(data) < length:
        raise EOFError
    return data


def serve(asked: IO[bytes], answers: IO[bytes]) -> None:
    """Compile texts until there are no more: first the processor's name and features come, then each text, and for each goes an object."""
    try:
        cpu, features = json.loads(take(asked))
        while True:
            put(answers, object_of(take(asked).decode(), cpu, features))
    except EOFError:
        return


if __name__ == "__main__":
    sys.path.append(sys.argv[1])  # where llvmlite is: the process was started without any packages
    serve(sys.stdin.buffer, sys.stdout.buffer)
