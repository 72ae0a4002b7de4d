# heatladder: verification and benchmarks for transient heat conduction.  `make help` lists the targets.

# Some awks use the locale's decimal comma.
export LC_ALL := C.UTF-8

# Apple's cc has no OpenMP: unless CC is given, scripts/compiler finds one that has.
ifneq ($(filter default undefined,$(origin CC)),)
CC       := cc
ifeq ($(shell uname),Darwin)
CC        = $(eval CC := $$(shell scripts/compiler))$(CC)
endif
endif
# Lines for a profile or a backtrace; a debugger wants CFLAGS='-O0 -g'.
CFLAGS   ?= -O3 -g1
WARN     := -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wvla -Wmissing-prototypes -Wstrict-prototypes
ifdef WERROR
WARN     += -Werror
endif
BUILD    ?= build
PREFIX   ?= /usr/local
ifneq ($(words $(BUILD)),1)
$(error BUILD='$(BUILD)': a path without blanks is wanted, as make's targets are)
endif
ifneq ($(filter / . .. ./ ../,$(BUILD)),)
$(error BUILD='$(BUILD)': a folder of its own is wanted, `make clean` removes it)
endif
PYTHON3  ?= /usr/bin/python3
LIBS     := gsl fftw3
# Expanded once, by the first recipe that needs them: `make setup test` installs pkg-config on the way.
PKG_CFLAGS = $(eval PKG_CFLAGS := $$(shell pkg-config --cflags $(LIBS)))$(PKG_CFLAGS)
PKG_LIBS   = $(eval PKG_LIBS := $$(shell pkg-config --libs $(LIBS)))$(PKG_LIBS)
CMOCKA     = $(eval CMOCKA := $$(shell pkg-config --cflags --libs cmocka))$(CMOCKA)
ALL_CFLAGS = -std=c11 -D_XOPEN_SOURCE=700 -ffp-contract=off -fopenmp $(WARN) -I. -I$(BUILD) $(CPPFLAGS) $(CFLAGS) $(PKG_CFLAGS)
ALL_LIBS   = $(PKG_LIBS) -fopenmp -lm $(LDLIBS)
ifndef V
Q := @
endif

# Results must be the same bits for any number of threads and any width of vectors, and NaN must be seen.
UNSAFE := $(filter -ffast-math -Ofast -funsafe-math-optimizations -fassociative-math -freciprocal-math \
  -ffinite-math-only -fno-signed-zeros -ffp-contract=fast% -ffp-contract=on -ffp-model=%,$(if $(filter file,$(origin CC)),,$(CC)) $(CPPFLAGS) $(CFLAGS) $(LDFLAGS))
ifneq ($(UNSAFE),)
$(error $(UNSAFE): the order of additions would be left to the compiler, or NaN be assumed away; leave it out)
endif

# A plain `make` uses all processors.
ifeq ($(MAKELEVEL)$(filter -j% --jobs% --jobserver%,$(MAKEFLAGS)),0)
MAKEFLAGS += -j$(shell getconf _NPROCESSORS_ONLN 2>/dev/null || echo 1)
endif

# Sources: every .c one folder deep, except tests, examples and programs of other codes.
SOURCES := $(filter-out verification/unit/% verification/examples/% references/library/% reports/bench/%, \
  $(wildcard $(foreach d,solver references verification reports,$(d)/*.c $(d)/*/*.c)))
OBJECTS := $(SOURCES:%.c=$(BUILD)/%.o)
PARTS   := $(filter-out $(BUILD)/verification/main.o,$(OBJECTS))
LIBRARY := $(BUILD)/parts.a
SHARED  := $(addprefix $(BUILD)/libheatladder,.a .so)
SCENES  := $(sort $(wildcard references/scene_*.c))
C_FILES := $(filter-out verification/examples/%,$(wildcard $(foreach d,solver references verification reports,\
  $(foreach e,[ch] inc,$(d)/*.$(e) $(d)/*/*.$(e)))))
TESTS   := $(patsubst verification/unit/%.c,$(BUILD)/unit/%,$(wildcard verification/unit/test_*.c))

.PHONY: FORCE action all bench check claims clean codes coverage dist examples faults field figures format front fuzz \
  gallery help install judged league lint mutants nightly operators race report sanitize setup setup-peers sph stability static \
  test uninstall verify walls wheel

##@ Build and install

all: $(BUILD)/heatladder $(SHARED) ## Build the program and the library

$(BUILD)/heatladder: $(OBJECTS)
	@echo "  LD    $@"
	$(Q)$(CC) $(ALL_CFLAGS) $(LDFLAGS) -o $@ $^ $(ALL_LIBS)

# Three files are rewritten when their text changes; compared before make begins, so that `make -q` works.
SPACE := $(subst x,,x x)
differs = $(if $(filter x$(subst $(SPACE),x,$(strip $(2))),x$(subst $(SPACE),x,$(strip $(shell cat $(1) 2>/dev/null)))),,FORCE)

# A scene is registered by its descriptor, `const struct scene scene_NAME = {`, in a file scene_*.c.
SCENE_LIST := $(sort $(shell sed -n 's/^const struct scene scene_\([a-z0-9_]*\) = {$$/SCENE(\1)/p' $(SCENES)))
$(BUILD)/scenes.inc: $(call differs,$(BUILD)/scenes.inc,$(SCENE_LIST))
	@mkdir -p $(@D)
	$(Q)printf '%s\n' $(SCENE_LIST:%='%') > $@.new && mv $@.new $@

# Release and commit.  The commit is git's in a checkout and the archive's in a tarball.  In a tree of another user git
# does not answer, and a build keeps its commit.
# archive of $Format:%h$
VERSION := 4.0.0
ARCHIVE := $(shell sed -n 's/^\# archive of \([0-9a-f]*\)$$/\1/p' Makefile)
COMMIT  := $(if $(wildcard .git),$(shell git describe --always --dirty=+ 2>/dev/null),$(ARCHIVE))
VERSION_LINE := \#define VERSION_TEXT "$(VERSION)$(if $(COMMIT), ($(COMMIT)))"
ifneq ($(wildcard .git)/$(COMMIT)/$(wildcard $(BUILD)/version.inc),.git//$(BUILD)/version.inc)
$(BUILD)/version.inc: $(call differs,$(BUILD)/version.inc,$(VERSION_LINE))
endif
$(BUILD)/version.inc:
	@mkdir -p $(@D)
	$(Q)printf '%s\n' '$(VERSION_LINE)' > $@.new && mv $@.new $@

# The tables of the papers, compiled in.
PUBLISHED := $(sort $(wildcard reports/published/*.csv))
$(BUILD)/published.inc: $(PUBLISHED) Makefile
	@mkdir -p $(@D)
	$(Q)for f in $(PUBLISHED); do b=$${f##*/}; echo "PUBLISHED(\"$${b%.csv}\","; \
	sed '/^#/d; s/,/", "/g; s/.*/{"&"},/' $$f; echo ')'; done >$@.new && mv $@.new $@

# Other flags or libraries compile all again, except in `make install` alone: sudo passes no flags on.
X86    = $(eval X86 := $$(filter x86_64%,$$(shell $$(CC) -dumpmachine)))$(X86)
LANES4 = $(if $(X86),-mavx2)
LANES8 = $(if $(X86),-mavx512f)
HIDDEN = -fPIC -fvisibility=hidden
# Solvers and references are compiled once, for program and library; each has these three functions of its own.
SHARED_CFLAGS = $(HIDDEN) $(foreach f,calloc realloc free,-D$f=guard_$f)
FLAGS  = $(CC) $(ALL_CFLAGS) $(SHARED_CFLAGS) $(LANES4) $(LANES8) $(LDFLAGS) $(ALL_LIBS)
GIVEN := $(filter environment command override,$(foreach v,CC CPPFLAGS CFLAGS LDFLAGS LDLIBS WERROR,$(origin $(v))))
ifneq ($(filter setup,$(MAKECMDGOALS)),) # pkg-config may not be here yet
$(BUILD)/flags: FORCE
else ifneq ($(MAKECMDGOALS)/$(GIVEN)/$(wildcard $(BUILD)/flags),install//$(BUILD)/flags)
$(BUILD)/flags: $(call differs,$(BUILD)/flags,$(FLAGS))
endif
$(BUILD)/flags:
	@mkdir -p $(@D)
	$(Q)pkg-config --exists $(LIBS) || { echo "make: pkg-config does not find $(LIBS): \`make setup\` installs them" >&2; exit 1; }
	$(Q)echo '$(subst ','"'"',$(FLAGS))' > $@.new; if cmp -s $@.new $@; then rm $@.new; else mv $@.new $@; fi

FORCE:

# Solvers and references take the time of a run, responses to faults that of a diagnosis; the other parts take longer
# to optimize than to run.
FAST_PARTS := solver/% references/% verification/fault/melting.c verification/fault/response.c
$(BUILD)/%.o: %.c $(BUILD)/flags | $(BUILD)/scenes.inc $(BUILD)/version.inc $(BUILD)/published.inc
	@mkdir -p $(@D)
	@echo "  CC    $<"
	$(Q)$(CC) $(if $(filter $(FAST_PARTS),$<),$(ALL_CFLAGS),$(patsubst -O3,-O1,$(ALL_CFLAGS))) \
	$(if $(filter solver/% references/%,$<),$(SHARED_CFLAGS)) $(DEFINES) -MMD -MP -c -o $@ $<

# One file a width of vectors; the processor is asked at run time.
$(BUILD)/solver/sweep/lanes4.o: DEFINES += $(LANES4)
$(BUILD)/solver/sweep/lanes8.o: DEFINES += $(LANES8)

# The library: solvers and references on one thread, with memory that returns to the caller where it runs out
# (references/library/guard.c).  Files with threads are compiled for it without OpenMP.  Symbols other than hl_... are
# hidden in the .so and local in the .a.
LIB_SOURCES := $(filter-out solver/out_of_memory.c,$(filter solver/% references/%,$(SOURCES)))
LIB_OWN     := $(shell grep -l 'pragma omp' $(LIB_SOURCES)) $(wildcard references/library/*.c)
LIB_OBJECTS := $(patsubst %.c,$(BUILD)/%.o,$(filter-out $(LIB_OWN),$(LIB_SOURCES))) $(LIB_OWN:%.c=$(BUILD)/library/%.o)
LIB_CFLAGS   = $(filter-out -fopenmp,$(ALL_CFLAGS)) -Wno-unknown-pragmas -Wno-unused-parameter $(SHARED_CFLAGS)
LIB_LIBS     = $(PKG_LIBS)
SONAME       = libheatladder.so.$(firstword $(subst ., ,$(VERSION)))
OBJCOPY     ?= objcopy

$(BUILD)/library/%.o: %.c $(BUILD)/flags | $(BUILD)/scenes.inc $(BUILD)/version.inc
	@mkdir -p $(@D)
	@echo "  CC    $< (library)"
	$(Q)$(CC) $(LIB_CFLAGS) $(DEFINES) -MMD -MP -c -o $@ $<

$(BUILD)/libheatladder.so: $(LIB_OBJECTS)
	$(Q)$(CC) $(LDFLAGS) $(CFLAGS) -shared $(if $(filter Darwin,$(shell uname)),,-Wl,-soname,$(SONAME) -Wl,--version-script=references/library/heatladder.map) -o $@ $^ $(LIB_LIBS) -lm -pthread $(LDLIBS)
	$(Q)ln -sf $(@F) $(@D)/$(SONAME)

$(BUILD)/libheatladder.a: $(LIB_OBJECTS)
	@rm -f $@
	$(Q)$(CC) -r -nostdlib -o $(BUILD)/library/heatladder.o $^ && { $(OBJCOPY) --localize-hidden $(BUILD)/library/heatladder.o 2>/dev/null || :; }
	$(Q)$(AR) qcs $@ $(BUILD)/library/heatladder.o

# Tests are linked with an archive, so that each takes the parts it needs.  Their own code takes longer to optimize
# than to run.
$(LIBRARY): $(PARTS)
	@rm -f $@
	$(Q)$(AR) qcs $@ $^

$(BUILD)/unit/%: verification/unit/%.c $(LIBRARY)
	@mkdir -p $(@D)
	@echo "  TEST  $@"
	$(Q)$(CC) $(patsubst -O3,-O1,$(ALL_CFLAGS)) -MMD -MP -MF $@.d -MT $@ $(LDFLAGS) -o $@ $< $(filter %.a %.so,$^) $(CMOCKA) $(ALL_LIBS) $(DEFINES)

$(BUILD)/unit/test_library: $(BUILD)/libheatladder.a

setup: ## Install what the build needs and this machine lacks
	$(Q)scripts/setup

# `make -j setup test` compiles nothing before setup is done.
ifneq ($(filter setup,$(MAKECMDGOALS)),)
$(addprefix $(BUILD)/,scenes.inc version.inc published.inc flags examples/cells_c examples/cells_f90 examples/cvode): | setup
endif

# File modes do not depend on the umask or the modes of the tree.
ROOT  = $(DESTDIR)$(PREFIX)
SHARE = $(ROOT)/share
LIBDIR = $(ROOT)/lib
install: all ## Install the program and the library under PREFIX (DESTDIR is put before it)
	$(Q)umask 022; set -e; echo "  INSTALL  $(ROOT)"; \
	for d in bin share/man/man1 share/bash-completion/completions share/heatladder/examples; do install -d "$(ROOT)/$$d"; done; \
	install -m 755 $(BUILD)/heatladder '$(ROOT)/bin/heatladder'; \
	scripts/manual $(BUILD)/heatladder >'$(SHARE)/man/man1/heatladder.1'; chmod 644 '$(SHARE)/man/man1/heatladder.1'; \
	install -m 644 scripts/completion.bash '$(SHARE)/bash-completion/completions/heatladder'; \
	install -m 644 verification/examples/* '$(SHARE)/heatladder/examples/'; \
	install -d '$(ROOT)/include' '$(LIBDIR)/pkgconfig'; \
	install -m 644 references/library/heatladder.h references/library/heatladder.f90 '$(ROOT)/include/'; \
	install -m 644 $(BUILD)/libheatladder.a '$(LIBDIR)/'; \
	install -m 755 $(BUILD)/libheatladder.so '$(LIBDIR)/$(SONAME)'; \
	ln -sf $(SONAME) '$(LIBDIR)/libheatladder.so'; \
	printf '%s\n' 'prefix=$(PREFIX)' 'Name: heatladder' 'Description: exact solutions and solvers of transient heat conduction' \
	'Version: $(VERSION)' 'Requires.private: $(LIBS)' 'Cflags: -I$${prefix}/include' 'Libs: -L$${prefix}/lib -lheatladder' \
	'Libs.private: -lm -pthread' >'$(LIBDIR)/pkgconfig/heatladder.pc'; \
	chmod 644 '$(LIBDIR)/pkgconfig/heatladder.pc'

uninstall: ## Remove what install put under PREFIX
	rm -f '$(ROOT)/bin/heatladder' '$(SHARE)/man/man1/heatladder.1' '$(SHARE)/bash-completion/completions/heatladder'
	rm -f '$(ROOT)/include/heatladder.h' '$(ROOT)/include/heatladder.f90' '$(LIBDIR)/pkgconfig/heatladder.pc' $(patsubst %,'$(LIBDIR)/%',libheatladder.a libheatladder.so $(SONAME))
	rm -rf '$(SHARE)/heatladder'

dist: ## Pack the last commit as build/heatladder-VERSION.tar.gz
	@mkdir -p $(BUILD)
	$(Q)git archive --prefix=heatladder-$(VERSION)/ -o $(BUILD)/heatladder-$(VERSION).tar.gz HEAD
	@echo "  DIST  $(BUILD)/heatladder-$(VERSION).tar.gz"

# One static binary, for a GitHub Action and a Python wheel.  Equal sources give equal bytes in any folder.
STATIC := $(BUILD)/static/heatladder

static: ## Build a static binary that needs no library: build/static/heatladder
	+$(Q)$(MAKE) --no-print-directory BUILD=$(BUILD)/static CFLAGS='-O3 -ffile-prefix-map=$(CURDIR)=.' LDFLAGS='-static -s' $(STATIC)

action: static ## Pack the static binary as a GitHub Action: build/action
	@rm -rf $(BUILD)/action && mkdir -p $(BUILD)/action
	$(Q)cp scripts/action/action.yml scripts/action/verify.sh $(STATIC) LICENSE $(BUILD)/action/
	@echo "  PACK  $(BUILD)/action"

# The library of the wheel carries GSL and FFTW.  Debian compiles cblas_xerbla (wrong arguments) for programs only.
WHOLE := $(BUILD)/whole/libheatladder.so
$(WHOLE): FORCE
	+$(Q)$(MAKE) --no-print-directory BUILD=$(BUILD)/whole CFLAGS='-O3 -ffile-prefix-map=$(CURDIR)=.' LDFLAGS=-s \
	LIB_LIBS='-Wl,--defsym=cblas_xerbla=0 -Wl,-Bstatic $(filter-out -lm,$(PKG_LIBS)) -Wl,-Bdynamic' $@

wheel: static $(WHOLE) ## Pack the static binary, the library and the Python package as a wheel: build/wheel/dist
	@rm -rf $(BUILD)/wheel && mkdir -p $(BUILD)/wheel
	$(Q)cp -R scripts/python/. $(BUILD)/wheel/ && mkdir -p $(addprefix $(BUILD)/wheel/heatladder/,bin lib)
	$(Q)cp $(STATIC) $(BUILD)/wheel/heatladder/bin/heatladder && cp $(WHOLE) $(BUILD)/wheel/heatladder/lib/
	$(Q)$(PYTHON3) $(BUILD)/wheel/pack_wheel.py $(BUILD)/wheel/dist
	@echo "  PACK  $$(ls $(BUILD)/wheel/dist/*.whl)"

clean: ## Remove everything that was built
	rm -rf $(BUILD) reports/out

# Small programs for --solver; not part of heatladder.
CVODE = $(wildcard /usr/include/cvode/cvode.h /usr/local/include/cvode/cvode.h)
VORO  = $(wildcard /usr/include/voro++/voro++.hh /usr/local/include/voro++/voro++.hh)
EXAMPLES = $(addprefix $(BUILD)/examples/,cells_c $(if $(shell command -v gfortran),cells_f90) $(if $(CVODE),cvode))
# deal.II takes 15 s to compile: for `make codes` alone, and only if PEERS has it or is not given.
DEALII   = $(if $(shell command -v mpicxx),$(wildcard /usr/include/deal.II/base/config.h))
JUDGED   = $(EXAMPLES) $(if $(DEALII),$(if $(filter dealii,$(PEERS))$(if $(PEERS),,all),$(BUILD)/examples/heat_dealii))
TIMED    = $(addprefix $(BUILD)/peers/,$(if $(CVODE),cvode_step) $(if $(VORO),voro_cells))
# Flags for the programs of others alone; they favour them in the comparison.
FAST    := -O3 -march=native -ffast-math -fopenmp-simd
sundials = $(patsubst %,-lsundials_%,$(1))

judged: $(JUDGED)
examples: $(EXAMPLES) ## Build the example programs for --solver

$(BUILD)/examples/cells_c: verification/examples/cells.c
	@mkdir -p $(@D)
	$(Q)$(CC) -O2 -o $@ $< -lm

$(BUILD)/examples/cells_f90: verification/examples/cells.f90
	@mkdir -p $(@D)
	$(Q)gfortran -O2 -J $(@D) -o $@ $<

$(BUILD)/examples/cvode: verification/examples/cvode.c
	@mkdir -p $(@D)
	$(Q)$(CC) -O2 -o $@ $< $(call sundials,cvode nvecserial sunlinsolband sunmatrixband) -lm

# Headers of deal.II name those of Trilinos and PETSc; its link line would name 200 libraries.
$(BUILD)/examples/heat_dealii: verification/examples/heat_dealii.cc
	@mkdir -p $(@D)
	$(Q)mpicxx -O2 $(addprefix -isystem /usr/include/,trilinos petsc slepc) -o $@ $< -Wl,--copy-dt-needed-entries -ldeal.ii

$(BUILD)/peers/cvode_step: reports/bench/cvode_step.c
	@mkdir -p $(@D)
	$(Q)$(CC) $(FAST) -o $@ $< $(call sundials,cvode nvecserial sunlinsolpcg) -lm

$(BUILD)/peers/voro_cells: reports/bench/voro_cells.cc
	@mkdir -p $(@D)
	$(Q)$(CXX) $(FAST) -o $@ $< -lvoro++

$(BUILD)/peers/cell_lists: reports/bench/cell_lists.c $(LIBRARY)
	@mkdir -p $(@D)
	$(Q)$(CC) $(ALL_CFLAGS) $(LDFLAGS) -o $@ $^ $(ALL_LIBS)

##@ Verify

# The longest come first, so that all processors are busy to the end.
SHELL_TESTS := $(addprefix scripts/tests/,examples.bats words.bats library.bats programs.bats limits.bats)
LONG_TESTS  := $(addprefix $(BUILD)/unit/test_,battery quantity diagnosis references ftcs gate_rows oracle)
check: test
test: $(TESTS) all examples ## Run the unit tests and, where bats is installed, the tests of the shell
	$(Q)PROGRAM=$(abspath $(BUILD)/heatladder) EXAMPLES=$(abspath $(BUILD)/examples) scripts/run_tests \
	$(firstword $(SHELL_TESTS)) $(LONG_TESTS) $(wordlist 2,9,$(SHELL_TESTS)) $(filter-out $(LONG_TESTS),$(TESTS))

verify: $(BUILD)/heatladder ## Run every gate, the papers' claims and a brief benchmark, then write the report, to reports/out; the first failure's status
	@mkdir -p $(OUT)/claims $(OUT)/brief
	$(Q)gates=0 claims=0 bench=0 report=0; \
	$(BUILD)/heatladder verify --json $(OUT)/gates.json --junit $(OUT)/junit.xml --page $(OUT)/gates.html || gates=$$?; \
	$(BUILD)/heatladder report claims $(OUT)/claims || claims=$$?; \
	$(BUILD)/heatladder bench --brief $(OUT)/brief >$(OUT)/brief/bench.txt || bench=$$?; \
	$(MAKE) --no-print-directory report || report=$$?; \
	for status in $$gates $$claims $$bench $$report; do [ $$status -eq 0 ] || exit $$status; done

##@ Tables and figures

# Tables and the data of figures need no gnuplot; the stamp is as old as they are.
OUT     := reports/out
SCRIPTS := $(wildcard reports/*/*_fig*.gp)
FIGURES := $(addprefix $(OUT)/,$(notdir $(SCRIPTS:.gp=.svg)) $(if $(wildcard $(OUT)/gates.csv),gates.svg) \
  $(if $(wildcard $(OUT)/brief/bench.json),brief.svg))

report: $(OUT)/report.stamp ## Write the papers' tables beside the measured ones, draw their figures, and join all in reports/out/index.html
	$(Q)if command -v gnuplot >/dev/null; then $(MAKE) --no-print-directory figures; \
	else echo "report: gnuplot is not here (make setup installs it); not drawn: $(notdir $(FIGURES:.svg=))"; fi
	$(Q)$(BUILD)/heatladder report page $(OUT)

$(OUT)/report.stamp: $(BUILD)/heatladder
	@mkdir -p $(OUT)
	$(Q)$(BUILD)/heatladder report $(OUT)
	@touch $@

figures: $(FIGURES)
	@:

# scripts/plot replaces whole figures: an interrupted make keeps the old ones.
.PRECIOUS: $(FIGURES)

vpath %.gp $(sort $(dir $(SCRIPTS))) reports/index reports/bench
$(OUT)/%.svg: %.gp $(wildcard reports/figure/*.gp) $(OUT)/report.stamp
	@echo "  PLOT  $(@:.svg=)"
	$(Q)scripts/plot $(OUT) $<
$(OUT)/gates.svg: $(OUT)/gates.csv
$(OUT)/brief.svg: $(OUT)/brief/bench.json

# Studies, each with its data and figures.
stability: ## Measure where methods fail and draw it, to reports/out
operators: ## Measure the discrete Laplacians side by side on every cloud and draw it, to reports/out
walls: ## Measure which treatment of walls keeps which order and draw it, to reports/out
front: ## Measure which mean of k(T) lets a front move and draw it, to reports/out
field: ## Measure conduction along a field and draw it, to reports/out
stability operators walls front field: $(BUILD)/heatladder
	@mkdir -p $(OUT)
	$(Q)$(BUILD)/heatladder report $@ $(OUT)
	$(Q)if command -v gnuplot >/dev/null; then for f in $(wildcard reports/$@/*.gp); do \
	scripts/plot $(OUT) $$f || exit 1; done; \
	else echo "$@: gnuplot is not here (make setup installs it); figures were not drawn"; fi

# The figures that README.md and reports/README.md show.
GALLERY := song_fig1b song_fig2a song_fig2b pamplona_fig5 stability_limits matched_fig1 operators_error operators_work operators_growth walls_error walls_work front_means field_patch field_error space_fig1

gallery: report stability operators walls front field ## Copy the figures that the README shows to reports/gallery
	@mkdir -p reports/gallery
	$(Q)cp $(GALLERY:%=$(OUT)/%.svg) reports/gallery/
	$(Q)scripts/record $(BUILD)/heatladder reports/gallery/session.svg
	$(Q)if [ -f $(OUT)/league/league.svg ]; then cp $(OUT)/league/league.svg reports/gallery/; \
	else echo "gallery: no chart of other codes here (make league draws it); the old one stays"; fi
	$(Q)if [ -f $(OUT)/codes.svg ]; then cp $(OUT)/codes.svg reports/gallery/; \
	else echo "gallery: no picture of other codes here (make codes draws it); the old one stays"; fi

claims: $(BUILD)/heatladder ## Measure the statements of papers; the ledger goes to reports/out/claims
	@mkdir -p $(OUT)/claims
	$(Q)$(BUILD)/heatladder report claims $(OUT)/claims

##@ Speed

# A benchmark says by which flags it was compiled.
$(BUILD)/verification/bench/bench_print.o: DEFINES = -DBENCH_FLAGS='"-std=c11 -ffp-contract=off -fopenmp $(CFLAGS)"'

BENCH := $(OUT)/bench
bench: $(BUILD)/heatladder ## Chart error against time and counted work, every scene, to reports/out/bench
	@mkdir -p $(BENCH)
	$(Q)$(BUILD)/heatladder bench $(BENCH) | tee $(BENCH)/bench.new && mv $(BENCH)/bench.new $(BENCH)/bench.txt
	$(Q)if command -v gnuplot >/dev/null; then for data in $(BENCH)/bench_*.csv; do \
	for chart in time work; do echo reports/bench/bench_$$chart.gp $$data; done; done | \
	xargs -n 2 -P $$(getconf _NPROCESSORS_ONLN) scripts/plot $(BENCH); \
	scripts/plot $(BENCH) reports/bench/error_time.gp; \
	else echo "bench: gnuplot is not here (make setup installs it); charts were not drawn"; fi

# PEERS='getfem scipy': keys of scripts/peers.txt, for both; without it, all.  ROWS='contact/*': those of the battery.
setup-peers: ## Install public codes from packages of Debian and PyPI: those of PEERS, or all
	$(Q)scripts/setup-peers $(PEERS)

codes: $(BUILD)/heatladder ## Judge the public codes that are installed (PEERS, or all) and write reports/out/codes.html
	@mkdir -p $(OUT)
	+$(Q)$(MAKE) -s --no-print-directory judged
	$(Q)$(if $(ROWS),ROWS='$(ROWS)' )scripts/codes $(BUILD)/heatladder $(BUILD) $(OUT) $(PEERS)

league: $(BUILD)/heatladder ## Time public codes (make setup-peers): error against seconds, beside ours
	@mkdir -p $(OUT)/league
	+$(Q)$(MAKE) -s --no-print-directory $(JUDGED) $(TIMED)
	$(Q)scripts/league $(BUILD)/heatladder $(BUILD) $(OUT)/league
	$(Q)if command -v gnuplot >/dev/null; then for data in $(OUT)/league/league*.csv; do \
	scripts/plot $(OUT)/league reports/bench/league.gp $$data; done; \
	else echo "league: gnuplot is not here (make setup installs it); the chart was not drawn"; fi

sph: $(BUILD)/heatladder $(BUILD)/peers/cell_lists ## Compare operators and neighbours with PySPH's and SciPy's; minutes
	$(Q)python=$$(scripts/interpreter pysph); [ -n "$$python" ] || { echo "sph: PySPH is not here (make setup-peers PEERS=pysph)" >&2; exit 1; }; \
	"$$python" reports/bench/neighbour_times.py $(BUILD)/peers/cell_lists && \
	"$$python" reports/bench/pysph_operators.py $(BUILD)/heatladder

faults: $(BUILD)/heatladder ## Seed faults in the examples; the battery must see each
	$(Q)CC='$(CC)' scripts/fault-table $(BUILD)/heatladder

##@ Develop

# False positives of cppcheck 2.10: tables that a NULL ends, and arguments that a call fills.
CPPCHECK := --quiet --error-exitcode=1 --std=c11 --enable=warning,portability --inline-suppr -I. \
            $(addprefix --suppress=,arrayIndexOutOfBounds arrayIndexThenCheck ctuuninitvar uninitvar)
PYTHON_FILES = $(wildcard reports/bench/*.py verification/examples/*.py scripts/python/*.py scripts/python/*/*.py) \
	scripts/codes scripts/league
SHELL_FILES = $(shell grep -lE '^\#!/bin/(ba)?sh' .ci/* $$(find scripts verification/examples -type f))

# Compiling the adapter of deal.II takes 10 s: examples are checked again when one has changed, or where a tool was missing.
$(BUILD)/examples.lint: scripts/lint_examples $(wildcard verification/examples/* references/library/heatladder.[hf]*)
	@mkdir -p $(@D)
	$(Q)CC='$(CC)' scripts/lint_examples >$@.new || { cat $@.new; exit 1; }
	$(Q)if [ -s $@.new ]; then cat $@.new; else mv $@.new $@; fi

lint: $(OBJECTS) $(BUILD)/examples.lint ## Check includes, symbols, words, seeded faults, the format, scripts, examples and (by cppcheck) common faults
	$(Q)scripts/check_floors
	$(Q)scripts/check_includes
	$(Q)scripts/check_symbols $(BUILD)
	$(Q)scripts/check_shared_lines
	$(Q)scripts/check_words
	$(Q)scripts/mutants --check
	$(Q)scripts/fault-table --check
	$(Q)case $$(clang-format --version 2>/dev/null) in *" 14."*) clang-format --dry-run --Werror $(C_FILES);; \
	*) echo "lint: clang-format 14 is not here: format not checked";; esac
	$(Q)if command -v shellcheck >/dev/null; then shellcheck -S warning $(SHELL_FILES); \
	else echo "lint: shellcheck is not here: scripts not checked"; fi
	$(Q)if command -v pyflakes3 >/dev/null; then pyflakes3 $(PYTHON_FILES); \
	else echo "lint: pyflakes3 is not here: Python not checked"; fi
	$(Q)if command -v cppcheck >/dev/null; then \
	cppcheck -j 2 $(CPPCHECK) $(filter-out solver/sweep/lanes%,$(SOURCES)); \
	else echo "lint: cppcheck is not here: common faults not checked"; fi

MUTANTS ?= *
mutants: ## Seed faults (rows MUTANTS of scripts/mutants.txt), one at a time; a test or a gate must see each
	$(Q)CC='$(CC)' scripts/mutants '$(MUTANTS)'

format: ## Lay out the sources by .clang-format
	clang-format -i $(C_FILES)

# verification/unit/fuzz_NAME.c starts from the inputs of corpus/NAME.
FUZZ_SECONDS ?= 20
FUZZERS := $(patsubst verification/unit/fuzz_%.c,%,$(wildcard verification/unit/fuzz_*.c))
FUZZ := -O1 -g -fsanitize=fuzzer-no-link,address,undefined -fno-sanitize-recover=all
fuzz: ## Look for input that breaks a reader: FUZZ_SECONDS each (20), by clang's libFuzzer
	+$(Q)$(MAKE) -s CC=clang BUILD=$(BUILD)/fuzz CFLAGS='$(FUZZ)' $(FUZZERS:%=$(BUILD)/fuzz/unit/fuzz_%)
	$(Q)printf '%s\n' $(FUZZERS) | xargs -P $$(getconf _NPROCESSORS_ONLN) -I {} sh -c 'mkdir -p $(BUILD)/fuzz/found/{}; \
	$(BUILD)/fuzz/unit/fuzz_{} -max_total_time=$(FUZZ_SECONDS) -max_len=4096 -print_final_stats=1 \
	-artifact_prefix=$(BUILD)/fuzz/{}- $(BUILD)/fuzz/found/{} verification/unit/corpus/{} \
	2>$(BUILD)/fuzz/{}.log || { tail -30 $(BUILD)/fuzz/{}.log; exit 1; }; \
	echo "fuzz: {}: $$(sed -n "s/^stat::number_of_executed_units: *//p" $(BUILD)/fuzz/{}.log) inputs, none breaks it"'

$(BUILD)/unit/fuzz_%: DEFINES += -fsanitize=fuzzer

SANITIZE := -O1 -g -fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer
# Rows that take half of the time and repeat code of others: space/ball/wall=2/fit, walls/disc/*/fit, contact/*,
# space/cosine/fo_ssph, space/jitter/positive, and the unit tests of clouds in space.
LONG_ROWS := space/contact/contact_ssph,space/ball/wall=[13]/fit,space/step/fo_ssph/first,space/jitter/so_ssph
sanitize: ## Run the unit tests and the quick gates under the address and undefined-behaviour sanitizers
	+$(Q)$(MAKE) -s BUILD=$(BUILD)/sanitize CFLAGS='$(SANITIZE)' SHELL_TESTS= test
	$(Q)$(BUILD)/sanitize/heatladder verify --quick --skip '$(LONG_ROWS)'

# A program that ends while it writes its counts leaves them broken: gcov names them in gcov.log, and they are removed.
COVER := $(BUILD)/coverage
coverage: ## Count the lines that unit tests and gates run, folder by folder, to reports/out/coverage.txt
	@mkdir -p $(OUT) $(COVER)
	$(Q)find $(COVER) \( -name '*.gcda' -o -name gcov.log \) -delete
	+$(Q)GCOV_ERROR_FILE='$(abspath $(COVER))/gcov.log' $(MAKE) -s BUILD=$(COVER) CFLAGS='-O1 --coverage' \
	LDFLAGS=--coverage SHELL_TESTS= test
	$(Q)sed -n 's/^libgcov profiling error:\(.*[.]gcda\):.*/\1/p' $(COVER)/gcov.log 2>/dev/null | xargs -r rm -f
	$(Q)$(COVER)/heatladder verify >/dev/null
	$(Q)scripts/coverage $(COVER) > $(OUT)/coverage.new && mv $(OUT)/coverage.new $(OUT)/coverage.txt && cat $(OUT)/coverage.txt

# clang's OpenMP reports waits of threads to the race detector; libraries without these marks are left out.
RACE := OMP_NUM_THREADS=4 OMP_TOOL_LIBRARIES=libarcher.so TSAN_OPTIONS='ignore_noninstrumented_modules=1 halt_on_error=1'
race: ## Run the quick gates on four threads under clang's race detector
	+$(Q)$(MAKE) -s CC=clang BUILD=$(BUILD)/race CFLAGS='-O1 -g -fsanitize=thread' all
	$(Q)$(RACE) $(BUILD)/race/heatladder verify --quick

nightly: all examples ## No optimization, races, valgrind, coverage, packages, fuzzers, ARM, all faults: two hours on two cores
	+$(Q)MAKE='$(MAKE)' BUILD='$(BUILD)' scripts/nightly

help: ## List the targets
	@awk -F':.*## ' '/^##@ /{printf "\n%s\n", substr($$0, 5)} /^[a-z-]+:.*## /{printf "  %-16s %s\n", $$1, $$2}' Makefile

-include $(sort $(OBJECTS:.o=.d) $(LIB_OBJECTS:.o=.d)) $(TESTS:=.d)
