# A thin face over CMake (see CMakePresets.json). `make help` lists the targets.
QUADLINE := build/release/quadline
PYTHON := /usr/bin/python3

.PHONY: help build demo test paper bench format tidy
help:
	@echo "make demo    set up, build, and mesh the ship's bulkhead into out/"
	@echo "make test    set up, build, and run every test"
	@echo "make build   build the release binary, $(QUADLINE)"
	@echo "make paper   mesh the paper's models and compare with its Table 3"
	@echo "make bench   run the benchmarks"
	@echo "make format  format the sources; make tidy: lint them"

build:
	@test -f build/release/build.ninja || cmake --preset release > /dev/null
	@cmake --build --preset release

demo: setup build
	@mkdir -p out
	@$(QUADLINE) mesh examples/bulkhead/bulkhead.json -o out/bulkhead.vtu -o out/bulkhead.msh -o out/bulkhead.inp \
	  -o out/bulkhead.svg -o out/bulkhead.json --report out/bulkhead-report.json
	@echo "Look at out/bulkhead.svg (browser), out/bulkhead.vtu (ParaView), out/bulkhead.msh (Gmsh); out/bulkhead.inp is for CalculiX and Abaqus."

test: setup build
	@test -f build/asan/build.ninja || cmake --preset asan > /dev/null
	@cmake --build --preset asan
	@ctest --preset asan -j2

paper: setup build
	@$(PYTHON) scripts/paper_table.py $(QUADLINE)

bench: setup build
	@build/release/benchmarks/quadline_benchmarks

format:
	@clang-format-19 -i $$(git ls-files '*.cpp' '*.hpp')

tidy: setup build
	@clang-tidy-19 -p build/release --quiet $$(git ls-files 'src/*.cpp' 'io/*.cpp' 'cli/*.cpp' 'draw/*.cpp')

.PHONY: setup
setup:
	@scripts/install-packages
