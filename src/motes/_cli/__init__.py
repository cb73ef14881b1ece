"""The commands of the shell, one a file.  They import what they need when they run, so that ``motes --help`` is quick."""
