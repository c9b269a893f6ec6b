# A thin face over CMake (see CMakePresets.json). `make help` lists the targets.
QUADLINE := build/release/quadline
PYTHON := /usr/bin/python3
SOURCES = $(shell find include src io cli tests benchmarks examples -name '*.cpp' -o -name '*.hpp')

.PHONY: help setup build demo test floor paper hard compare bench soak fuzz coverage mutants format tidy clean
help:
	@echo "make demo    set up, build, and mesh the ship's bulkhead into out/"
	@echo "make test    set up, build, and run every test"
	@echo "make floor   build with the oldest compilers that shall do, and compare the meshes"
	@echo "make build   build the release binary, $(QUADLINE)"
	@echo "make paper   mesh the paper's models and compare with its Table 3"
	@echo "make hard    mesh the hard models, for the table in docs/robustness.md"
	@echo "make compare compare the meshes with Gmsh's, in docs/quality.md"
	@echo "make bench   run the benchmarks"
	@echo "make soak    mesh random models until one fails (SOAK='--keep-going --seconds 600')"
	@echo "make fuzz    run each fuzz target for a minute (FUZZ_SECONDS=60)"
	@echo "make coverage  the share of the lines that the tests reach"
	@echo "make mutants break a line at a time and see whether the tests notice (MUTANTS='--only *gap*'); hours"
	@echo "make format  format the sources"
	@echo "make tidy    lint them"
	@echo "make clean   remove build/ and out/"

setup:
	@scripts/install-packages

build:
	@test -f build/release/build.ninja || cmake --preset release > /dev/null
	@cmake --build --preset release

demo: setup
	@$(MAKE) --no-print-directory build
	@mkdir -p out
	@$(QUADLINE) mesh examples/bulkhead/bulkhead.json -o out/bulkhead.vtu -o out/bulkhead.msh -o out/bulkhead.inp \
	  -o out/bulkhead.svg -o out/bulkhead.json --report out/bulkhead-report.json
	@echo "Look at $(CURDIR)/out/bulkhead.svg with a browser, at bulkhead.vtu with ParaView, at bulkhead.msh with Gmsh;"
	@echo "bulkhead.inp is for CalculiX and Abaqus, bulkhead-report.json has the figures."

test: setup
	@$(MAKE) --no-print-directory build
	@test -f build/asan/build.ninja || cmake --preset asan > /dev/null
	@cmake --build --preset asan
	@test -f build/tsan/build.ninja || cmake --preset tsan > /dev/null
	@cmake --build --preset tsan
	@ctest --preset tsan
	@ctest --preset asan -j2

floor: setup
	@scripts/check-floor

paper: setup
	@$(MAKE) --no-print-directory build
	@$(PYTHON) scripts/paper_table.py $(QUADLINE)
	@$(QUADLINE) mesh examples/plate/plate.json -o docs/images/plate.svg --quiet
	@for model in models/layout/*.json; do \
	  $(QUADLINE) mesh $$model -o docs/images/$$(basename $$model .json).svg --quiet; done

hard: setup
	@$(MAKE) --no-print-directory build
	@$(PYTHON) scripts/hard_table.py $(QUADLINE)

compare: setup
	@$(MAKE) --no-print-directory build
	@scripts/install-gmsh build/compare-venv
	@build/compare-venv/bin/python benchmarks/compare/compare.py --quadline $(QUADLINE)
	@$(PYTHON) benchmarks/compare/symmetry.py --quadline $(QUADLINE)

bench: setup
	@$(MAKE) --no-print-directory build
	@cmake --build --preset release --target quadline_benchmarks
	@build/release/benchmarks/quadline_benchmarks

soak: setup
	@$(MAKE) --no-print-directory build
	@cmake --build --preset release --target quadline_soak
	@build/release/tests/soak/quadline_soak $(SOAK)

fuzz: setup
	@scripts/run-fuzz $(or $(FUZZ_SECONDS),60)

coverage: setup
	@test -f build/coverage/build.ninja || cmake --preset coverage > /dev/null
	@cmake --build --preset coverage
	@find build/coverage -name '*.gcda' -delete
	@ctest --preset coverage -j2
	@$(PYTHON) scripts/coverage.py

mutants: setup
	@$(PYTHON) scripts/mutants.py $(MUTANTS)

format:
	@clang-format-19 -i $(SOURCES)

tidy: setup
	@scripts/check-tidy || [ $$? -eq 77 ]

clean:
	@rm -rf build out
