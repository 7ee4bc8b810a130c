# SPDX-License-Identifier: BSD-3-Clause
"""The covering, the influence areas and Algorithm 3 of *Efficient Collision Detection between 2D Polygons* (Jimenez, Segura and
Feito, 2004), for readers of the paper. Other programs need nothing of it.

>>> from tricover import paper
>>> len(paper.covering(tc.Polygon.box(2, 2)).sign)
4
"""
from . import _tricover
from ._enums import InfluenceKind

__all__ = ["InfluenceKind", "bounded_influence_area", "collide", "covering", "in_influence_area", "influence_mask"]

bounded_influence_area = _tricover._paper.bounded_influence_area
collide = _tricover._paper.collide
covering = _tricover._paper.covering
in_influence_area = _tricover._paper.in_influence_area
influence_mask = _tricover._paper.influence_mask
