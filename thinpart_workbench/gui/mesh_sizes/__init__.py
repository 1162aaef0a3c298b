"""The command 'Prepare mesh': element sizes for a part, and its FEM mesh."""
