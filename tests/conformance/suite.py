# SPDX-License-Identifier: Apache-2.0
"""The files of the Khronos conformance suite, and the picture that each is to be compared with.

A folder of the suite holds a file, perhaps further ones that it refers to, and in Blessed/ the picture that
Khronos calls right: one in Blessed/png, or the frames of an animation in Blessed/animations. Many have none.
Blessed/default.txt names them, with the backslashes of Windows.
"""
from dataclasses import dataclass
from pathlib import Path


CAMERA = "testCamera"  # the one that the suite's own scripts ask programs to render from


@dataclass(frozen=True)
class Case:
    file: Path             # below the suite's folder
    picture: Path | None   # below the suite's folder, too
    without: str = ""      # why there is no picture


def own_picture(folder):
    """The picture that a folder blesses, or why there is none."""
    blessed = folder / "Blessed"
    listed = blessed / "default.txt"
    if listed.is_file():
        names = [line.strip().replace("\\", "/") for line in listed.read_text(errors="replace").splitlines()]
        names = [name for name in names if (blessed / name).is_file()]
        if len(names) == 1:
            return blessed / names[0], ""
        if names:
            return None, "its pictures are the frames of an animation"
    pictures = sorted((blessed / "png").glob("*.[pP][nN][gG]"))
    return (pictures[0], "") if len(pictures) == 1 else (None, "the suite has no picture of it")


def is_judged(file):
    """Whether the picture of its folder is this file's: not that of one that another refers to."""
    return len([*file.parent.glob("*.dae"), *file.parent.glob("*.zae")]) == 1 or file.stem == file.parent.name


def has_camera(file, name=None):
    """Whether a file has a camera, or a camera's node of that name. Archives are not opened."""
    text = file.read_bytes()
    if name and f'name="{name}"'.encode() not in text:
        return False
    return file.suffix != ".dae" or b"<instance_camera" in text


def case_of(file, root):
    relative = file.relative_to(root)
    if not has_camera(file):
        return Case(relative, None, "it has no camera, and the suite does not say which one it took")
    if not is_judged(file):
        return Case(relative, None, "another file of its folder refers to it, or replaces it")
    picture, without = own_picture(file.parent)
    return Case(relative, picture.relative_to(root) if picture else None, without)


def cases(root):
    """Every scene file below the folder, in order; what the suite made of them (Blessed) is none."""
    files = [*root.rglob("*.dae"), *root.rglob("*.zae")]
    return [case_of(file, root) for file in sorted(files) if "Blessed" not in file.parts]
