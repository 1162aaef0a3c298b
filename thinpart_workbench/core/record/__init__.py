"""The part record: the result that info files, colours, panels and tables use."""
