"""ThinPart: tells before meshing whether a CAD part is thin, and where."""

__version__ = "0.1.0"
