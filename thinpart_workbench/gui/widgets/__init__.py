"""General widgets that do not depend on parts or documents."""
