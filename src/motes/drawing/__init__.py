"""What pages and pictures are drawn with: colour, markup, SVG, lit spheres."""
