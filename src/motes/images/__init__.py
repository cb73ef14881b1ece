"""Picture files: OpenEXR and PNG."""
