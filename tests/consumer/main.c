#include <stdio.h>

#include "strainwave/strainwave.h"

int main(void) {
  sw_answer* answer = NULL;
  const sw_text command = {"catalogue", 9};
  const sw_text none = {NULL, 0};
  sw_error* error = sw_run(NULL, command, none, NULL, 0, NULL, &answer);
  if (error != NULL) return 1;
  printf("strainwave %s\n", sw_version());
  sw_answer_free(answer);
  return 0;
}
