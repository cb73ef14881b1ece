"""Picture files by OpenImageIO: OpenEXR, PNG, TIFF and JPEG, and what their numbers mean."""
