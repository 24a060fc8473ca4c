# scattered.py: prints a glTF of many instances of one small tetrahedron, each at a place of its own.
import base64
import json
import random
import struct

random.seed(4)
corners = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)]
faces = [0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3]
data = struct.pack("<12f12H", *(value for corner in corners for value in corner), *faces)
nodes = [{"mesh": 0, "translation": [random.uniform(0, 40) for _ in range(3)]} for _ in range(60)]
print(json.dumps({
    "asset": {"version": "2.0"},
    "scene": 0,
    "scenes": [{"nodes": list(range(len(nodes)))}],
    "nodes": nodes,
    "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
    "accessors": [
        {"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 1]},
        {"bufferView": 1, "componentType": 5123, "count": 12, "type": "SCALAR"},
    ],
    "bufferViews": [{"buffer": 0, "byteLength": 48}, {"buffer": 0, "byteOffset": 48, "byteLength": 24}],
    "buffers": [{"byteLength": len(data), "uri": "data:application/octet-stream;base64," + base64.b64encode(data).decode()}],
}))
