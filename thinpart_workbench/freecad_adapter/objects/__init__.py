"""Document objects of ThinPart: thickness maps and wall measurements; and snapshots of parts for worker processes."""
