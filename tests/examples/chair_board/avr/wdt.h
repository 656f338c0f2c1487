// The watchdog.
#pragma once

const int WDTO_60MS = 2;

void wdt_enable(int limit);
void wdt_disable();
void wdt_reset();
