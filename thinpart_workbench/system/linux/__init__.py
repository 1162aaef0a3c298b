"""What only Linux has: its system calls, and the privileges of processes."""
