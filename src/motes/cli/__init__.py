"""The commands of the shell, one a file; each imports what it needs when it runs, so that ``motes --help`` is quick."""
