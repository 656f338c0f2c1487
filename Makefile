PYTHON ?= python3
PORT ?= 8080
VENV := .venv
BIN := $(VENV)/bin
TSC := $(BIN)/node node_modules/typescript/bin/tsc
PRETTIER := $(BIN)/node node_modules/prettier/bin/prettier.cjs --log-level warn
# What prettier writes; types/api.d.ts is made by a program.
PRETTY := "web_static/js/**/*.js" "web_static/css/**/*.css" "tests/**/*.mjs" "types/!(api).d.ts"
INSTALL := $(BIN)/python -m pip install --quiet --disable-pip-version-check
# Packages are those whose digests stand in requirements/; these are complete, so that pip looks for no others. Python
# compiles a module when it first imports it: the many that nothing imports take neither time nor 90 MB.
PINNED := $(INSTALL) --no-compile --no-deps --require-hashes --requirement
OWN := $(INSTALL) --no-index --no-deps --no-build-isolation

# A module is compiled once, and not by each of the many processes that the tests start.
unexport PYTHONDONTWRITEBYTECODE

.PHONY: demo test browser check format lint python-types javascript-types api-types
.PHONY: safety compiled drills physics worlds sensors sources-tried soak long-recording people-soak large-clinic photographs
.PHONY: words bench bench-compare verdicts page shipped pins clean

$(VENV)/.installed: pyproject.toml hatch_build.py front_end_packages.py package-lock.json requirements/run.txt requirements/build.txt
	@echo "Installing into $(VENV), once; this takes a minute or two ..."
	@test -x $(BIN)/python || $(PYTHON) -m venv $(VENV)
	@$(BIN)/python -m pip uninstall --quiet --quiet --yes setuptools  # of Python 3.11's venv: old, and of no use here
	@$(PINNED) requirements/build.txt
	@$(OWN) --editable .
	@touch $@

$(VENV)/.installed-test: $(VENV)/.installed requirements/compile.txt requirements/test.txt
	@$(PINNED) requirements/test.txt
	@touch $@

node_modules/.installed: package.json package-lock.json $(VENV)/.installed-test
	@$(BIN)/npm ci --ignore-scripts --silent
	@touch $@

demo: $(VENV)/.installed
	@exec $(BIN)/bodydrive demo --port $(PORT)

# First what computes, then what waits for real processes and judges them by the clock, then what waits for browsers:
# side by side, these would wait for each other, and a machine that is too busy fails them. A file is run by one process,
# except where each test starts processes of its own; a group (`xdist_group`) shares what it starts.
SIDE_BY_SIDE := -n 3 --dist loadfile --no-loadscope-reorder
ONE_BY_ONE := --dist loadgroup --no-loadscope-reorder
# Whole programs work by the clock: on a slow processor fewer of them run side by side.
AT_MOST = -n $$($(BIN)/python tests/side_by_side.py $(1))
PROCESSES := tests/processes tests/bench
BROWSERS := tests/browser
# Browser tests of the pages that differ from the branch main, and always a few; BROWSER_TESTS=tests/browser: all.
BROWSER_TESTS = $$($(BIN)/python tests/browser/touched.py)

test: $(VENV)/.installed-test check
	$(BIN)/python -m pytest $(SIDE_BY_SIDE) $(addprefix --ignore=,$(PROCESSES) $(BROWSERS))
	$(BIN)/python -m pytest $(ONE_BY_ONE) $(call AT_MOST,4) $(PROCESSES)
	$(BIN)/python -m pytest $(SIDE_BY_SIDE) $(call AT_MOST,2) $(BROWSER_TESTS)

# The longer stories in a browser.
browser: $(VENV)/.installed-test
	$(BIN)/python -m pytest $(SIDE_BY_SIDE) $(call AT_MOST,2) -m long $(BROWSERS)

check: $(VENV)/.installed-test node_modules/.installed
	@$(MAKE) --no-print-directory --jobs 2 --output-sync=target python-types lint javascript-types $(VENV)/.compiled

# Once after the installation, beside the check of types: otherwise each process of the first tests compiles everything.
$(VENV)/.compiled: $(VENV)/.installed-test
	@$(BIN)/python -m pytest -qq --collect-only >$@.part || { cat $@.part; rm $@.part; false; }
	@mv $@.part $@

lint: $(VENV)/.installed-test node_modules/.installed
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	$(PRETTIER) --check $(PRETTY)

format: $(VENV)/.installed-test node_modules/.installed
	$(BIN)/ruff format .
	$(PRETTIER) --write $(PRETTY)

python-types: $(VENV)/.installed-test
	$(BIN)/mypy

javascript-types: node_modules/.installed
	$(TSC)
	$(TSC) --project tsconfig.worker.json

api-types: node_modules/.installed
	PYTHONPATH=.:tests $(BIN)/python tests/api_types.py

# The digests in requirements/, of the pinned versions; NEWEST=1 takes the newest versions that fit together.
pins: $(VENV)/.installed
	@$(PINNED) requirements/pins.txt
	PYTHONPATH=tests $(BIN)/python tests/supply/pins.py $(if $(NEWEST),--newest)

safety: $(VENV)/.installed-test
	@$(PINNED) requirements/safety.txt
	$(BIN)/python tests/mutation.py

# A wheel, compiled, in a folder of its own: its drives and tests are compared with those of plain Python.
COMPILED := build/compiled
COMPILED_TESTS := -m "not long and not uncompiled" tests/pipeline tests/world tests/study tests/hardware
compiled: $(VENV)/.installed-test
	@rm -rf $(COMPILED)
	@BODYDRIVE_COMPILE=must $(OWN) --target $(COMPILED) .
	$(BIN)/python tests/compiled/equal_drives.py $(COMPILED)
	PYTHONPATH=$(COMPILED) $(BIN)/pytest $(SIDE_BY_SIDE) $(COMPILED_TESTS)

# The long tests that need no browser, then injuries at random moments.
drills: $(VENV)/.installed-test
	$(BIN)/python -m pytest $(ONE_BY_ONE) $(call AT_MOST,2) -m long $(addprefix --ignore=,$(BROWSERS))
	PYTHONPATH=tests $(BIN)/python -m drills --jobs 2 --out docs/drills.md

# A wheelchair in MuJoCo behind the receiver: 200 drives on each floor and the page; DRIVES=20 only prints.
physics: $(VENV)/.installed-test
	PYTHONPATH=tests $(BIN)/python -m physics --jobs 2 $(if $(DRIVES),--drives $(DRIVES),--out docs/physics.md)

soak: $(VENV)/.installed-test
	PYTHONPATH=tests $(BIN)/python -m soak --out docs/viewers.md

# Each driver of a shirt at its full rate against an emulator: SENSOR=UDP prints one and writes nothing; SENSOR_TIME in s.
sensors: $(VENV)/.installed-test
	PYTHONPATH=.:tests $(BIN)/python -m sensors --jobs 5 $(if $(SENSOR_TIME),--seconds $(SENSOR_TIME)) \
		$(if $(SENSOR),--only "$(SENSOR)",--out docs/sensors-measured.md)

# Each source of movements in a browser, from a demonstration to a scored trial: SOURCES="udp camera" prints these and
# writes nothing. Photographs: build/sources-tried.
sources-tried: $(VENV)/.installed-test
	PYTHONPATH=.:tests $(BIN)/python -m sources_tried $(if $(SOURCES),--only $(SOURCES),--out docs/sensors-measured.md)

long-recording: $(VENV)/.installed-test
	PYTHONPATH=.:tests $(BIN)/python -m soak.recording

people-soak: $(VENV)/.installed-test
	PYTHONPATH=tests $(BIN)/python -m soak.people --minutes $(or $(MINUTES),30)

# A clinic of 200 patients, 4,000 sessions and 60,000 trials, made in a minute: how quickly it starts and answers.
large-clinic: $(VENV)/.installed-test
	PYTHONPATH=.:tests $(BIN)/python -m large_clinic

# Every page in every state, for people to look at: CELLS="1280x800/dark 390x844/light/200", or all that count.
photographs: $(VENV)/.installed-test
	PYTHONPATH=tests $(BIN)/python -m browser.eyes.photographs $(CELLS) $(if $(PLACES),--places "$(PLACES)")

worlds: $(VENV)/.installed-test
	$(BIN)/python -m pytest tests/worlds/each_task.py

bench: $(VENV)/.installed-test
	$(BIN)/python -m bench $(or $(PART),--out docs/speed.md)

# Simulated people who are called better or worse than noise: the tables of docs/learning/verdicts.md; about five minutes.
verdicts: $(VENV)/.installed-test
	$(BIN)/python -m bench.learning.verdicts --people $(or $(PEOPLE),1000)

# What a language of the pages lacks (docs/translating.md).
words: $(VENV)/.installed-test
	@PYTHONPATH=tests $(BIN)/python -m words $(or $(LANGUAGE),$(error name a language, as in: make words LANGUAGE=es))

bench-compare: $(VENV)/.installed-test
	$(BIN)/python -m bench.compare $(or $(COMMIT),$(error name a commit, as in: make bench-compare COMMIT=main)) $(PART)

# What a program writes and git keeps: a page of docs/, as in `make page PAGE=promises`, or a file that ships with the
# program, as in `make shipped FILE=icons`. Without a name, both list what there is.
WITH_TESTS := PYTHONPATH=.:tests
PAGE_drills = $(MAKE) --no-print-directory drills
PAGE_mutation = $(MAKE) --no-print-directory safety
PAGE_physics = $(MAKE) --no-print-directory physics
PAGE_pictures = $(WITH_TESTS) $(BIN)/python -m pictures
# Maps from other people, on real people (../shared/data/knit_people) and simulated ones kept apart; about ten minutes.
PAGE_prior-measured = $(WITH_TESTS) $(BIN)/python -m bench.prior --people $(or $(PEOPLE),20)
PAGE_promises = $(WITH_TESTS) $(BIN)/python -m promises
# Both halves, one after the other. Who first commits this page adds its line to docs/README.md, which a test asks for.
PAGE_sensors-measured = $(MAKE) --no-print-directory --keep-going --jobs 1 sensors sources-tried
PAGE_speed = $(MAKE) --no-print-directory bench
PAGE_verdicts = $(MAKE) --no-print-directory verdicts
PAGE_viewers = $(MAKE) --no-print-directory soak

# What the application's own calibration makes of the demonstration's patient.
SHIPPED_demo-profile = $(WITH_TESTS) $(BIN)/python tests/cli/demonstration_profile.py
# The fonts of reports, of the unpacked packages fonts-noto-core and fonts-noto-cjk in the folder FROM.
SHIPPED_fonts = $(WITH_TESTS) $(BIN)/python tests/features/reports/report_fonts.py $(or $(FROM),$(error name a folder, as in: make shipped FILE=fonts FROM=unpacked))
SHIPPED_icons = $(WITH_TESTS) $(BIN)/python tests/web_static/home_screen_icons.py
# The prior of simulated people, for the simulated shirt.
SHIPPED_prior = $(WITH_TESTS) $(BIN)/python tests/cli/shipped_prior.py

names = $(sort $(patsubst $(1)_%,%,$(filter $(1)_%,$(.VARIABLES))))
page: $(VENV)/.installed-test
	$(or $(PAGE_$(PAGE)),$(error name a page, as in: make page PAGE=promises; there are: $(call names,PAGE)))

shipped: $(VENV)/.installed-test node_modules/.installed
	$(or $(SHIPPED_$(FILE)),$(error name a file, as in: make shipped FILE=icons; there are: $(call names,SHIPPED)))

clean:
	rm -rf $(VENV) node_modules web_static/vendor dist build
