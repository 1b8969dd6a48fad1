/* SPDX-License-Identifier: Apache-2.0 */
/* A program in C that goes the whole way: edit, read, run, answer, documents, batch, errors. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "strainwave/strainwave.h"

#define EXPECT(condition)                                                     \
  do {                                                                        \
    if (!(condition)) {                                                       \
      fprintf(stderr, "%s:%d: not so: %s\n", __FILE__, __LINE__, #condition); \
      exit(1);                                                                \
    }                                                                         \
  } while (0)

static sw_text text(const char* string) {
  const sw_text result = {string, strlen(string)};
  return result;
}

static int has(sw_text where, const char* what) {
  const size_t size = strlen(what);
  for (size_t i = 0; i + size <= where.size; ++i)
    if (memcmp(where.data + i, what, size) == 0) return 1;
  return 0;
}

/* Ends the program with the message of an error. */
static void succeed(sw_error* error) {
  if (error == NULL) return;
  const sw_text message = sw_error_text(error, SW_MESSAGE);
  fprintf(stderr, "%.*s\n", (int)message.size, message.data);
  exit(1);
}

static ptrdiff_t next_of_file(void* file, char* bytes, size_t size) {
  return (ptrdiff_t)fread(bytes, 1, size < 100 ? size : 100, file);
}

static void close_file(void* file) { fclose(file); }

static int find_nothing(void* context, sw_text name, sw_source* source) {
  (void)context;
  (void)name;
  (void)source;
  return 1;
}

struct collected {
  size_t size;
  int commits;
};

static int collect(void* context, const char* bytes, size_t size) {
  (void)bytes;
  ((struct collected*)context)->size += size;
  return 0;
}

static int commit(void* context) {
  ++((struct collected*)context)->commits;
  return 0;
}

static int stop(void* context, double fraction) {
  EXPECT(fraction >= 0 && fraction <= 1);
  ++*(int*)context;
  return 1;
}

int main(int n_arguments, char** arguments) {
  EXPECT(n_arguments == 2);
  EXPECT(strlen(sw_version()) >= 5);
  sw_text commands;
  succeed(sw_commands(&commands));
  EXPECT(has(commands, "\"name\":\"stiffness\""));
  sw_text_free(commands);

  const sw_source file = {next_of_file, close_file, fopen(arguments[1], "rb")};
  EXPECT(file.context != NULL);
  const sw_attachments none = {NULL, 0, find_nothing, NULL};
  sw_drive* drive = NULL;
  succeed(sw_read_from(file, text("drive.toml"), &none, &drive));

  sw_text fields;
  succeed(sw_drive_fields(drive, &fields));
  EXPECT(has(fields, "\"ratio\": 100"));
  EXPECT(has(fields, " N*m\""));
  sw_text_free(fields);

  sw_answer* answer = NULL;
  succeed(sw_run(drive, text("stiffness"), text("{\"method\": \"corrected\"}"), NULL, 0, NULL,
                 &answer));
  EXPECT(sw_answer_usable(answer) == 1);
  sw_text json;
  succeed(sw_answer_document(answer, text("json"), &json));
  EXPECT(has(json, "\"format\": \"strainwave-result/1\""));
  struct collected collected = {0, 0};
  const sw_sink sink = {collect, commit, &collected};
  succeed(sw_answer_write(answer, text("json"), &sink));
  EXPECT(collected.size == json.size && collected.commits == 1);
  sw_text_free(json);
  sw_answer_free(answer);

  const sw_text paths[] = {text("load.torque")};
  const sw_text outputs[] = {text("intact.stiffness"), text("cracked.positive.stiffness")};
  const double values[] = {10, 0, 20};
  const sw_batch_task task = {paths, 1, values, 3, outputs, 2, text("corrected"), 2};
  double numbers[6];
  int codes[3];
  sw_text faults[SW_ROW_CODES];
  succeed(sw_batch(drive, &task, NULL, numbers, codes, faults));
  EXPECT(codes[0] == SW_ROW_OK && codes[2] == SW_ROW_OK);
  EXPECT(numbers[0] > numbers[1] && numbers[1] > 0);
  for (int i = 0; i < SW_ROW_CODES; ++i) sw_text_free(faults[i]);
  int calls = 0;
  const sw_progress progress = {stop, &calls};
  sw_error* error = sw_batch(drive, &task, &progress, numbers, codes, NULL);
  EXPECT(error != NULL && sw_error_code(error) == SW_STOPPED && calls == 1);
  sw_error_free(error);
  sw_drive_free(drive);

  const sw_text value = text("\"3 mm\"");
  sw_text edited;
  succeed(sw_edit(text("[drive]\nratio = 100\n"), text("drive.pitch_diameter"), &value, &edited));
  EXPECT(has(edited, "pitch_diameter = \"3 mm\""));
  error = sw_read(edited, text("edited.toml"), NULL, &drive);
  EXPECT(error != NULL && sw_error_code(error) == SW_INPUT && sw_error_line(error) > 0);
  EXPECT(has(sw_error_text(error, SW_FILE), "edited.toml"));
  sw_error_free(error);
  sw_text_free(edited);
  return 0;
}
