// Compiled only where no folder beside this file is of the board's processor.
#error "eigenshade has no library for this board: see its README.md"
