"""Writes a small figure with horns and feet that stand off as points, one a voxel of 20 x 20 x 21."""

points = []
for x in range(20):
    for y in range(20):
        for z in range(21):
            is_body = 5 <= x < 15 and 3 <= y < 15 and 6 <= z < 15
            is_horn = x in (5, 14) and y >= 3 and z == 10
            is_foot = x in (4, 15) and y < 2 and z < 21
            if is_body or is_horn or is_foot or (x, y, z) in ((0, 9, 9), (19, 9, 9)):
                points.append((x, y, z))
print("ply\nformat ascii 1.0\nelement vertex %d\nproperty float x\nproperty float y\nproperty float z\nend_header"
      % len(points))
for point in points:
    print(*(value + 0.5 for value in point))
