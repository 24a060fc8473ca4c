"""torch_depths.py [STEPS]: a network learns how far rays see in a volume. Each step traces a new batch of rays, whose hits the network's
answers are compared with: no data set is made. Needs PyTorch."""
import sys

import torch
import voxc

RAYS = 4096


def rays(extent, chance):
    """A batch from a ball around the volume to chance voxels within it: origins and directions of length 1."""
    middle = extent / 2
    around = torch.nn.functional.normalize(torch.randn(RAYS, 3, generator=chance), dim=-1)
    origins = middle + extent.max() * around
    targets = torch.rand(RAYS, 3, generator=chance) * extent
    return origins, torch.nn.functional.normalize(targets - origins, dim=-1)


def main():
    steps = int(sys.argv[1]) if len(sys.argv) > 1 else 300
    volume = voxc.build("R(2^3) G(4)", "builtin:terrain:64")
    tracer = volume.tracer()
    extent = torch.tensor(volume.extent, dtype=torch.float32)
    chance = torch.Generator().manual_seed(1)
    torch.manual_seed(1)
    network = torch.nn.Sequential(torch.nn.Linear(6, 128), torch.nn.ReLU(), torch.nn.Linear(128, 128), torch.nn.ReLU(), torch.nn.Linear(128, 1))
    optimizer = torch.optim.Adam(network.parameters(), 2e-3)
    losses = []
    for step in range(steps):
        origins, directions = rays(extent, chance)
        hits = tracer.trace(origins, directions)
        depths, places = torch.from_dlpack(hits["t"]), torch.from_dlpack(hits["voxel"])  # The memory of the hits, without a copy.
        hit = places[:, 0] >= 0
        guess = network(torch.cat([origins / extent.max(), directions], -1))[:, 0]
        loss = torch.nn.functional.mse_loss(guess[hit], depths[hit] / extent.max())
        optimizer.zero_grad()
        loss.backward()
        optimizer.step()
        losses.append(loss.item() ** 0.5 * float(extent.max()))
        if step % 50 == 0 or step == steps - 1:
            print(f"step {step}: off by {losses[-1]:.2f} voxels, of {int(hit.sum())} rays that hit")
    assert sum(losses[-10:]) < sum(losses[:10]), "nothing was learnt"


main()
