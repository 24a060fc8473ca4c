"""Writes emitting.gltf: a square whose light and metal its material says."""
import base64
import json
import struct
import sys

numbers = [0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0]
buffer = struct.pack("<12f6H", *numbers, 0, 1, 2, 0, 2, 3)
json.dump(
    {
        "asset": {"version": "2.0"},
        "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1, "material": 0}]}],
        "materials": [
            {
                "emissiveFactor": [1, 0.5, 0],
                "pbrMetallicRoughness": {
                    "baseColorFactor": [0, 0, 1, 1],
                    "metallicFactor": 0.2,
                    "roughnessFactor": 0.6,
                },
            }
        ],
        "accessors": [
            {"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3"},
            {"bufferView": 1, "componentType": 5123, "count": 6, "type": "SCALAR"},
        ],
        "bufferViews": [
            {"buffer": 0, "byteLength": 48},
            {"buffer": 0, "byteOffset": 48, "byteLength": 12},
        ],
        "buffers": [
            {
                "byteLength": 60,
                "uri": "data:application/octet-stream;base64," + base64.b64encode(buffer).decode(),
            }
        ],
    },
    open(sys.argv[1] + "/emitting.gltf", "w"),
)
