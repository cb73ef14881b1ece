"""Put models together, evaluate and sample them, and take a gradient with PyTorch where it is installed."""

import numpy as np

import motes
from motes.directions import from_spherical

rock = motes.OrenNayar(K_d=(0.8, 0.7, 0.6), sigma_d=0.4) + motes.TorranceSparrow(K_s=0.3, sigma_s=0.15)
dusty = motes.DustLayer(rock, motes.Dust(w=(0.7, 0.6, 0.5), g=0.3), tau=0.2)

wi = from_spherical(np.radians(50), 0.0)
wo = from_spherical(np.radians([0, 25, 50, 75]), np.pi)  # on the specular side
print("theta_r [deg], the BRDF [1/sr] of the rock and of the dusty rock in R, G, B")
for angle, clean, dusted in zip((0, 25, 50, 75), rock.eval(wi, wo), dusty.eval(wi, wo), strict=True):
    print(f"{angle:3}  {clean.round(4)}  {dusted.round(4)}")

# The mean weight of samples estimates the directional albedo.
u = np.random.default_rng(0).random((100_000, 2))
sampled = dusty.sample(wi, u)
print("directional albedo by sampling   ", sampled.weight.mean(axis=0).round(3))
print("directional albedo by integration", dusty.directional_albedo(wi).round(3))

try:
    import torch
except ImportError:
    print("PyTorch is not installed: no gradient")
else:
    tau = torch.tensor(0.2, dtype=torch.float64, requires_grad=True)
    value = motes.DustLayer(rock, motes.Dust(w=(0.7, 0.6, 0.5), g=0.3), tau=tau).eval(wi, wo)
    value.sum().backward()
    step = 1e-6
    plus, minus = (motes.DustLayer(rock, dusty.dust, tau=0.2 + s).eval(wi, wo).sum() for s in (step, -step))
    print(f"d sum(f) / d tau: {tau.grad.item():.6f} by PyTorch, {(plus - minus) / (2 * step):.6f} by differences")
