# SPDX-License-Identifier: BSD-3-Clause
"""GeoJSON, WKT and __geo_interface__. What is a polygon and what isn't, the compiled module says."""
import json
import os
from typing import Any, Dict, List, NamedTuple, Sequence, Tuple, Union

from . import _tricover as _module
from ._results import _documented
from ._tricover import Polygon

# Its private functions are not in the stub.
_tricover: Any = _module

__all__ = ["GeoFeature", "parse_geo_json", "parse_wkt", "read_geo_json", "to_geo_json", "write_geo_json"]


@_documented
class GeoFeature(NamedTuple):
    """A polygon of a file, with its properties.

    polygon: The union of the feature's parts, each of which is its shell without its holes.
    id: The feature's id, a str or a number, or None.
    properties: The feature's properties, or None.
    rounded_crossings: How many vertices were added where parts that overlap cross.
    rounded_coordinates: How many coordinates changed by rounding when the origin was subtracted.

    >>> tc.GeoFeature(tc.Polygon.box(2, 2), id=17, properties={"speed": 2.5}).properties["speed"]
    2.5
    """
    polygon: Polygon
    id: Any = None
    properties: Any = None
    rounded_crossings: int = 0
    rounded_coordinates: int = 0


def _loaded(feature: Tuple[Polygon, str, str, int, int]) -> GeoFeature:
    polygon, name, properties, crossings, coordinates = feature
    return GeoFeature(polygon, json.loads(name) if name else None, json.loads(properties) if properties else None, crossings,
                      coordinates)


def _dumped(feature: GeoFeature) -> Tuple[Polygon, str, str, int, int]:
    def text(value: Any) -> str:
        return "" if value is None else json.dumps(value, default=_plain, ensure_ascii=False)

    if not isinstance(feature, GeoFeature):
        raise TypeError(f"features: a GeoFeature is wanted, not a {type(feature).__name__}")
    return (feature.polygon, text(feature.id), text(feature.properties), *feature[3:])


def read_geo_json(path: Union[str, "os.PathLike[str]"], origin: Any = (0, 0), skip_others: bool = False) -> List[GeoFeature]:
    """Reads the polygons of a GeoJSON file, with their properties. `origin`, (2,), is subtracted from all coordinates.

    Points and lines are errors unless skip_others leaves them out. A file that can't be read or isn't GeoJSON is a
    RuntimeError that names the feature, the ring and the vertex.

    >>> tc.read_geo_json("nowhere.json")
    Traceback (most recent call last):
    RuntimeError: ...
    """
    return [_loaded(feature) for feature in _tricover._read_geo_json(os.fspath(path), origin, skip_others)]


def parse_geo_json(text: str, origin: Any = (0, 0), skip_others: bool = False) -> List[GeoFeature]:
    """Reads GeoJSON from a text, as read_geo_json() does from a file.

    >>> tc.parse_geo_json('{"type": "Polygon", "coordinates": [[[0, 0], [2, 0], [0, 2], [0, 0]]]}')[0].polygon
    Polygon([(0.0, 0.0), (2.0, 0.0), (0.0, 2.0)])
    """
    return [_loaded(feature) for feature in _tricover._parse_geo_json(text, origin, skip_others)]


def parse_wkt(text: str, origin: Any = (0, 0)) -> GeoFeature:
    """Reads a POLYGON or a MULTIPOLYGON in WKT.

    >>> tc.parse_wkt("POLYGON ((0 0, 2 0, 0 2, 0 0))").polygon
    Polygon([(0.0, 0.0), (2.0, 0.0), (0.0, 2.0)])
    """
    return _loaded(_tricover._parse_wkt(text, origin))


def to_geo_json(given: Union[Polygon, Sequence[GeoFeature]]) -> str:
    """Returns a polygon as a GeoJSON geometry, or features as a FeatureCollection.

    >>> tc.to_geo_json(tc.Polygon([(0, 0), (2, 0), (0, 2)]))[:27]
    '{"type":"Polygon","coordina'
    """
    if isinstance(given, Polygon):
        return str(_tricover._polygon_to_geo_json(given))
    return str(_tricover._features_to_geo_json([_dumped(feature) for feature in given]))


def write_geo_json(path: Union[str, "os.PathLike[str]"], features: Sequence[GeoFeature]) -> None:
    """Writes features into a GeoJSON file, which it replaces.

    >>> tc.write_geo_json("/nowhere/parts.json", [tc.GeoFeature(tc.Polygon.box(2, 2))])
    Traceback (most recent call last):
    RuntimeError: ...
    """
    _tricover._write_geo_json(os.fspath(path), [_dumped(feature) for feature in features])


def _plain(value: Any) -> Any:
    """What json can't write: NumPy's arrays and numbers."""
    if hasattr(value, "tolist"):
        return value.tolist()
    raise TypeError(f"it can't be written as JSON: {value!r}")


def _geometry(given: Any) -> Dict[str, Any]:
    """Of a collection of features, their geometries are one collection."""
    if not isinstance(given, dict):
        interface = getattr(given, "__geo_interface__", None)
        if interface is None:
            raise TypeError(f"geometry: an object with __geo_interface__ or its dictionary is wanted, not a {type(given).__name__}")
        return _geometry(dict(interface))
    if given.get("type") == "Feature":
        return {"type": "Feature", "properties": None, "geometry": given.get("geometry")}
    if given.get("type") == "FeatureCollection":
        return {"type": "GeometryCollection", "geometries": [_geometry(one)["geometry"] for one in given.get("features", ())]}
    return given


def polygon_from(given: Any) -> Polygon:
    """The region of an object with __geo_interface__, or of such a dictionary."""
    try:
        feature, = _tricover._parse_geo_json(json.dumps(_geometry(given), default=_plain), (0, 0), False)
    except RuntimeError as error:
        # There is no file, and no option to leave geometries out.
        what = str(error).partition("; set GeoOptions")[0]
        raise ValueError(what.replace("tricover: GeoJSON", "geometry", 1)) from None
    return feature[0]


def geometry_of(polygon: Polygon) -> Dict[str, Any]:
    """The dictionary that is __geo_interface__."""
    def tuples(value: Any) -> Any:
        return tuple(tuples(one) for one in value) if isinstance(value, list) else float(value)

    geometry = json.loads(_tricover._polygon_to_geo_json(polygon))
    return {"type": geometry["type"], "coordinates": tuples(geometry["coordinates"])}


for _name in __all__:
    globals()[_name].__module__ = "tricover"
