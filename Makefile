# make demo    install the packages, build, and walk through the sample building
# make test    build and run the tests
# make         build the program: build/release/app/enfilade
PRESET ?= release
BUILD := build/$(PRESET)
ENFILADE := $(BUILD)/app/enfilade
FORMATTED := $(shell git ls-files '*.cpp' '*.h' 2>/dev/null)

.PHONY: all setup configure build test demo bench format format-check install clean

all: build

setup:
	@scripts/setup

configure: setup
	@mkdir -p build
	@cmake --preset $(PRESET) > $(BUILD).log 2>&1 || { cat $(BUILD).log; exit 1; }

# The program alone: what a user needs.
build: configure
	cmake --build --preset $(PRESET) --target enfilade

test: configure
	cmake --build --preset $(PRESET)
	ctest --preset $(PRESET) -j 2

demo: build
	scripts/demo $(ENFILADE) demo

bench: PRESET := bench
bench: setup
	@scripts/setup libbenchmark-dev
	cmake --preset bench && cmake --build --preset bench
	@for program in build/bench/tests/bench/*_bench; do echo "== $$program"; $$program; done

format:
	clang-format -i $(FORMATTED)

format-check:
	@clang-format --dry-run --Werror $(FORMATTED)

install: build
	cmake --install $(BUILD)

clean:
	rm -rf build demo
