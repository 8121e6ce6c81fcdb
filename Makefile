# make demo    install the packages and furniture, build, and walk through haunted (or SAMPLE=gallery, brooks)
# make test    build and run the tests
# make         build the program: build/release/app/enfilade
# make fuzz    feed every reader of files broken ones, for SECONDS_EACH=60 seconds a format
# make test PRESET=asan, or tsan: the tests under clang's sanitizers
# make tidy    look for faults that compilers pass over, in all sources or those changed SINCE=COMMIT
# make figures reproduce the paper's figures: docs/figures.md
PRESET ?= release
BUILD := build/$(PRESET)
ENFILADE := $(BUILD)/app/enfilade
HOUSES ?= brooks haunted
SECONDS_EACH ?= 60
export SECONDS_EACH
FORMATTED := $(shell git ls-files '*.cpp' '*.h' 2>/dev/null)

.PHONY: all setup configure build test demo figures bench fuzz tidy format format-check install clean

all: build

setup:
	@scripts/setup $(if $(filter asan tsan,$(PRESET)),clang-19 libclang-rt-19-dev llvm-19)

configure: setup
	@mkdir -p build
	@cmake --preset $(PRESET) $(CONFIGURE) > $(BUILD).log 2>&1 || { cat $(BUILD).log; exit 1; }

# The program alone: what a user needs.
build: configure
	cmake --build --preset $(PRESET) --target enfilade

test: configure
	@scripts/setup ffmpeg xdotool xvfb
	cmake --build --preset $(PRESET)
	ctest --preset $(PRESET) -j 2

demo: build
	@scripts/setup sweethome3d-furniture
	scripts/demo $(ENFILADE) demo $(SAMPLE)

# Of the houses named in HOUSES; results in docs, what they were made from in the folder figures.
figures: build
	@scripts/setup gnuplot-nox imagemagick jq python3 sweethome3d-furniture
	scripts/figures/figures $(ENFILADE) figures docs $(HOUSES)

bench: PRESET := bench
bench: setup
	@scripts/setup libbenchmark-dev
	cmake --preset bench && cmake --build --preset bench
	@for program in build/bench/tests/bench/*_bench; do echo "== $$program"; $$program; done

fuzz: setup
	@scripts/setup clang-19 libclang-rt-19-dev
	cmake --preset asan && cmake --build --preset asan --target fuzzers
	scripts/fuzz build/asan $(TARGETS)

tidy: setup
	@scripts/setup clang-19 clang-tidy-19
	@cmake --preset tidy > build/tidy.log
	scripts/tidy build/tidy $(SINCE)

format:
	clang-format -i $(FORMATTED)

format-check:
	@clang-format --dry-run --Werror $(FORMATTED)

install: build
	cmake --install $(BUILD)

clean:
	rm -rf build demo figures
