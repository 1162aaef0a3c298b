# SPDX-License-Identifier: LGPL-2.1-or-later
"""Damage to files, the same for the same seed."""

import io
import random
import re
import struct
import zipfile

_NUMBER = re.compile(rb"-?\d+(?:\.\d*)?(?:[eE][+-]?\d+)?")
_ODD_NUMBERS = (b"0", b"-1", b"1e308", b"-1e308", b"1e999", b"nan", b"2147483648", b"-2147483649", b"18446744073709551616",
                b"9" * 400, b"1e-320", b"0.0000000000001")
_ODD_TEXTS = (b"", b"\0" * 64, b"\xff" * 64, b"'" * 33, b"(" * 2000, b"%s%n%x", b"../" * 20 + b"etc/passwd",
              b"#1", b"$", b"*;", b"<!--", b"]]>", b"&x;", "\u202e\ud83d\ude00".encode("utf-16-le", "surrogatepass"))


def damaged(content, name, seed):
    """The content of a file with one to four kinds of damage.

    Parameters
    ----------
    content : bytes
    name : str
        By its ending it is known what a file is made of.
    seed : int

    Returns
    -------
    bytes
    """
    chance = random.Random(seed)
    if zipfile.is_zipfile(io.BytesIO(content)) and chance.random() < 0.7:
        return _damaged_archive(content, chance)
    for _ in range(chance.randint(1, 4)):
        content = chance.choice(_DAMAGE)(content, chance)
    return content


def _flip(content, chance):
    changed = bytearray(content)
    for _ in range(chance.choice((1, 8, 100)) if changed else 0):
        changed[chance.randrange(len(changed))] ^= 1 << chance.randrange(8)
    return bytes(changed)


def _overwrite(content, chance):
    start, length = _stretch(content, chance)
    return content[:start] + chance.randbytes(length) + content[start + length:]


def _zero(content, chance):
    start, length = _stretch(content, chance)
    return content[:start] + bytes(length) + content[start + length:]


def _remove(content, chance):
    start, length = _stretch(content, chance)
    return content[:start] + content[start + length:]


def _repeat(content, chance):
    start, length = _stretch(content, chance)
    return content[:start] + content[start:start + length] * chance.choice((2, 3, 40)) + content[start + length:]


def _cut(content, chance):
    return content[:chance.randrange(len(content) + 1)]


def _append(content, chance):
    return content + chance.choice((bytes(4096), b"\xff" * 4096, content[:5000], chance.randbytes(4096)))


def _exchange(content, chance):
    start, length = _stretch(content, chance)
    other = chance.randrange(len(content) + 1)
    return content[:other] + content[start:start + length] + content[other:]


def _other_number(content, chance):
    found = list(_NUMBER.finditer(content))
    for match in sorted(chance.sample(found, min(len(found), chance.choice((1, 3, 20)))), key=lambda each: -each.start()):
        content = content[:match.start()] + chance.choice(_ODD_NUMBERS) + content[match.end():]
    return content


def _other_text(content, chance):
    start, length = _stretch(content, chance, 40)
    return content[:start] + chance.choice(_ODD_TEXTS) + content[start + length:]


def _lines(content, chance):
    lines = content.split(b"\n")
    chance.choice((chance.shuffle, list.reverse, lambda all_lines: all_lines.pop(chance.randrange(len(all_lines)))))(lines)
    return b"\n".join(lines)


def _number_in_binary(content, chance):
    start = chance.randrange(max(1, len(content) - 8))
    odd = chance.choice((struct.pack("<I", 0xFFFFFFFF), struct.pack("<f", float("nan")), struct.pack("<d", float("inf")),
                         struct.pack("<q", -1), struct.pack("<I", 0x7FFFFFFF)))
    return content[:start] + odd + content[start + len(odd):]


_DAMAGE = (_flip, _overwrite, _zero, _remove, _repeat, _cut, _append, _exchange, _other_number, _other_text, _lines,
           _number_in_binary)


def _stretch(content, chance, most=None):
    start = chance.randrange(len(content) + 1)
    return start, min(len(content) - start, chance.choice((1, 16, 300, len(content) // 3 + 1) if most is None else (most,)))


def _damaged_archive(content, chance):
    """An archive that is whole, of entries that are not, or are called something else, or missing, or there twice."""
    with zipfile.ZipFile(io.BytesIO(content)) as archive:
        entries = [(name, archive.read(name)) for name in archive.namelist()]
    for _ in range(chance.randint(1, 3)):
        number = chance.randrange(len(entries))
        name, data = entries[number]
        what = chance.randrange(10)
        if what < 6:
            entries[number] = name, chance.choice(_DAMAGE)(data, chance)
        elif what == 6 and len(entries) > 1:
            del entries[number]
        elif what == 7:
            entries.append((name, chance.choice(entries)[1]))
        elif what == 8:
            entries[number] = name, chance.choice(entries)[1]
        else:
            entries[number] = chance.choice(("../" * 9 + name, "/" + name, name + "\0x", "x" * 300, "")), data
    made = io.BytesIO()
    with zipfile.ZipFile(made, "w", chance.choice((zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED))) as archive:
        for name, data in entries:
            # Names are written as they are, whatever zipfile thinks of them.
            archive.writestr(zipfile.ZipInfo(name), data)
    content = made.getvalue()
    return _flip(content, chance) if chance.random() < 0.1 else content
