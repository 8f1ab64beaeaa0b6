"""The solid of a STEP file as a mesh."""

import collections
import pathlib

from OCP.BRep import BRep_Tool
from OCP.BRepAdaptor import BRepAdaptor_Surface
from OCP.BRepMesh import BRepMesh_IncrementalMesh
from OCP.collections import Sequence_TCollection_AsciiString
from OCP.GeomAbs import GeomAbs_SurfaceType
from OCP.IFSelect import IFSelect_ReturnStatus
from OCP.IMeshTools import IMeshTools_Parameters
from OCP.STEPControl import STEPControl_Reader
from OCP.TopAbs import TopAbs_Orientation, TopAbs_ShapeEnum
from OCP.TopExp import TopExp_Explorer
from OCP.TopLoc import TopLoc_Location
from OCP.TopoDS import TopoDS

from lab.errors import InputError

# Neighbouring strips of a round surface turn by at most this angle (rad), whatever its distance (mm) from them.
# `assembly-plan` finds round surfaces by strips that turn by less than 25 degrees.
ANGLE = 0.15
DEFLECTION = 10.0
# Shortest edge (mm) of small round surfaces.
SHORTEST = 1e-3
# Vertices nearer than this (mm) are one: faces that meet have the same points on their common edge, but for rounding.
SAME = 1e-7


def read(path: pathlib.Path) -> tuple:
    """The shape of a STEP file in millimetres, and the names of the file's units of length."""
    if not path.is_file():
        raise InputError(f"{path}: there is no such file")
    reader = STEPControl_Reader()
    if reader.ReadFile(str(path)) != IFSelect_ReturnStatus.IFSelect_RetDone:
        raise InputError(f"{path}: it is no STEP file")
    units = [Sequence_TCollection_AsciiString() for _ in range(3)]
    reader.FileUnits(*units)
    reader.TransferRoots()
    if reader.NbShapes() == 0:
        raise InputError(f"{path}: it has no shapes")
    return reader.OneShape(), [name.ToCString() for name in units[0]]


def within(shape, kind) -> list:
    """The faces or solids of a shape."""
    explorer = TopExp_Explorer(shape, kind)
    found = []
    while explorer.More():
        found.append(explorer.Current())
        explorer.Next()
    return found


def faces(shape) -> list:
    """The faces of a shape."""
    return [TopoDS.Face(face) for face in within(shape, TopAbs_ShapeEnum.TopAbs_FACE)]


def triangles(face) -> list:
    """The triangles of a face as points (mm), outward anticlockwise."""
    location = TopLoc_Location()
    triangulation = BRep_Tool.Triangulation_s(face, location)
    if triangulation is None:
        raise InputError("a face cannot be divided into triangles: repair the solid in the CAD program")
    move = location.Transformation()
    nodes = [triangulation.Node(index + 1).Transformed(move) for index in range(triangulation.NbNodes())]
    points = [(node.X(), node.Y(), node.Z()) for node in nodes]
    is_reversed = face.Orientation() == TopAbs_Orientation.TopAbs_REVERSED
    result = []
    for index in range(triangulation.NbTriangles()):
        corners = [points[corner - 1] for corner in triangulation.Triangle(index + 1).Get()]
        result.append(corners[::-1] if is_reversed else corners)
    return result


def obj(solids: list) -> str:
    """The text of the mesh of some solids."""
    numbers: dict[tuple[int, ...], int] = {}
    vertices, lines = [], []
    for face in (face for solid in solids for face in faces(solid)):
        for corners in triangles(face):
            triangle = []
            for corner in corners:
                key = tuple(round(coordinate / SAME) for coordinate in corner)
                if key not in numbers:
                    numbers[key] = len(numbers) + 1
                    vertices.append("v " + " ".join(f"{coordinate:.17g}" for coordinate in corner))
                triangle.append(numbers[key])
            if len(set(triangle)) == 3:
                lines.append("f " + " ".join(map(str, triangle)))
    return "\n".join(vertices + lines) + "\n"


def diameters(solids: list) -> list[str]:
    """The diameters (mm) of the cylinders, each with the number of its faces, a line each."""
    surfaces = [BRepAdaptor_Surface(face) for solid in solids for face in faces(solid)]
    cylinders = [surface for surface in surfaces if surface.GetType() == GeomAbs_SurfaceType.GeomAbs_Cylinder]
    counts = collections.Counter(2.0 * surface.Cylinder().Radius() for surface in cylinders)
    return [f"cylinder of diameter {diameter!r} mm: {count} faces" for diameter, count in sorted(counts.items())]


def convert(step: pathlib.Path, file: pathlib.Path) -> None:
    """Reads, writes and says what it found."""
    shape, units = read(step)
    solids = within(shape, TopAbs_ShapeEnum.TopAbs_SOLID)
    if not solids:
        raise InputError(f"{step}: it has no solid, only surfaces or curves; export the part as a solid")
    parameters = IMeshTools_Parameters()
    parameters.Angle, parameters.Deflection, parameters.MinSize = ANGLE, DEFLECTION, SHORTEST
    BRepMesh_IncrementalMesh(shape, parameters)
    text = obj(solids)
    file.write_text(text)
    print(f"unit of the file: {', '.join(units)}; {len(solids)} solids")
    print("\n".join(diameters(solids)))
    print(f"written to {file} with {text.count(chr(10) + 'f ')} triangles; its unit is mm")
