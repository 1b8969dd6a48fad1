/* SPDX-License-Identifier: Apache-2.0 */
#ifndef STRAINWAVE_STRAINWAVE_H
#define STRAINWAVE_STRAINWAVE_H

/**
 * @file
 * The C interface of strainwave, C11: libstrainwave.so.0 exports only these functions.
 *
 * The caller reads a drive from text, runs a command on it by name, and gets the answer as JSON or
 * as another document.  The commands, their options and their results are those of the program
 * `strainwave`; sw_commands lists them, and the command `schema` gives their JSON Schemas.
 *
 * The library opens no file, reads no clock, environment or locale, and prints nothing.  It does
 * not keep global state.  Several threads may use one handle at once, but the call that frees a
 * handle must be the last call with it.  No C++ exception leaves the library.  A callback must not
 * throw or jump out of the library.
 *
 * Text is UTF-8 with an explicit length.  Numbers are doubles in SI units.
 *
 * A function that can fail returns NULL on success, or an error that the caller frees by
 * sw_error_free.  It sets its output only on success.
 */

#include <stddef.h>

/* NOLINTBEGIN(modernize-use-using,readability-identifier-naming): C has its own conventions */

#if defined(__GNUC__)
/** Marks a function that the library exports. */
#define SW_API __attribute__((visibility("default")))
#else
/** Marks a function that the library exports. */
#define SW_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

typedef struct sw_drive sw_drive;   /**< a drive that was read and checked */
typedef struct sw_answer sw_answer; /**< what a command answered */
typedef struct sw_error sw_error;   /**< why a function failed */

/** Text that another party owns; data may be NULL if size is 0. */
typedef struct sw_text {
  const char* data; /**< UTF-8; need not end with a null byte */
  size_t size;      /**< [bytes] */
} sw_text;

/** A source of text, read piece by piece. */
typedef struct sw_source {
  /** Writes at most `size` next bytes to `bytes`; returns their number, 0 at the end, < 0 for a
   * fault. */
  ptrdiff_t (*next)(void* context, char* bytes, size_t size);
  /** Called once after the last read, also after a fault; may be NULL. */
  void (*close)(void* context);
  void* context; /**< passed to both functions */
} sw_source;

/** A sink for a document, written piece by piece. */
typedef struct sw_sink {
  /** Takes the next bytes; returns 0, or anything else for a fault. */
  int (*write)(void* context, const char* bytes, size_t size);
  /** Called once, after the last byte; before this call the document is not complete.
   *  Returns 0, or anything else for a fault; may be NULL. */
  int (*commit)(void* context);
  void* context; /**< passed to both functions */
} sw_sink;

/** A text with the name that a drive or an option gives. */
typedef struct sw_attachment {
  sw_text name; /**< as the drive or the option gives it */
  sw_text text; /**< its content */
} sw_attachment;

/** Texts that a drive names, such as compliance tables.  The array is searched first; for a name
 *  that it lacks, the callback is called.  A compliance table is at most 1 MiB
 *  long; the other texts are read piece by piece and have no limit. */
typedef struct sw_attachments {
  const sw_attachment* array; /**< may be NULL if count is 0 */
  size_t count;               /**< number of texts in the array */
  /** Opens the text with a name: sets *text and returns 0, or returns anything else if the text
   * does not exist; may be NULL. */
  int (*find)(void* context, sw_text name, sw_source* text);
  void* context; /**< passed to find */
} sw_attachments;

/** Lets a caller follow the progress of a computation and stop it. */
typedef struct sw_progress {
  /** Receives the completed fraction, 0 to 1, on the thread that called the library, at least every
   *  50 ms; returns 0 to continue, or anything else to stop. */
  int (*report)(void* context, double fraction);
  void* context; /**< passed to report */
} sw_progress;

/** Reason of a failure; the numbers are the exit codes of the program, which never exits with
 *  SW_CALLBACK. */
typedef enum sw_code {
  SW_OPTION = 2,     /**< the command, an option or another argument cannot be understood */
  SW_INPUT = 3,      /**< the drive breaks a rule, or holds what the command cannot treat */
  SW_NO_ANSWER = 4,  /**< the numerical method does not deliver */
  SW_INTERNAL = 70,  /**< a mistake of the library; please report it */
  SW_NO_MEMORY = 71, /**< there is not enough memory */
  SW_CALLBACK = 74,  /**< a source or a sink reported a fault */
  SW_STOPPED = 130   /**< the caller asked to stop */
} sw_code;

/** The parts of an error that are text. */
typedef enum sw_error_part {
  SW_MESSAGE = 0, /**< one sentence that has all other parts; never empty */
  SW_FILE = 1,    /**< name of the text with the fault, as it was given to sw_read */
  SW_FIELD = 2,   /**< "output_shaft.crack[0].depth", or the name of the option */
  SW_VALUE = 3,   /**< as it is written in the text, or with its unit */
  SW_RULE = 4     /**< that the value breaks: "> 0" */
} sw_error_part;

/** Outcome of one row of a batch. */
typedef enum sw_row_code {
  SW_ROW_OK = 0,           /**< its numbers may be used */
  SW_ROW_REFUSED = 1,      /**< its values break a rule of the input */
  SW_ROW_NO_ANSWER = 2,    /**< the method does not deliver */
  SW_ROW_NOT_USABLE = 3,   /**< it has numbers, which may not be used */
  SW_ROW_OUTPUT_ABSENT = 4 /**< its result has not all of the outputs */
} sw_row_code;

/** Number of values of sw_row_code. */
#define SW_ROW_CODES 5

/** Many evaluations of one drive with different numbers. */
typedef struct sw_batch_task {
  const sw_text* paths;   /**< n_paths: "output_shaft.crack[0].depth" */
  size_t n_paths;         /**< numbers of the drive that vary; 1 or more */
  const double* values;   /**< shape (n_rows, n_paths), row after row [SI unit of the field] */
  size_t n_rows;          /**< number of evaluations */
  const sw_text* outputs; /**< n_outputs: "cracked.positive.stiffness" */
  size_t n_outputs;       /**< numbers that each evaluation gives */
  sw_text method;         /**< "as-printed", "repaired" or "corrected" */
  int threads;            /**< 1 to 256; 0: as many as the machine has */
} sw_batch_task;

/** How far the numbers of a batch that reads the compliances of cracks from tables are from single
 *  evaluations (ST-22).  All is 0 if there is nothing to compare: no row read a table, or none of
 *  the compared rows has numbers. */
typedef struct sw_table_evidence {
  int cracks;           /**< cracks that have tables */
  int points;           /**< random rows at which tables and engine were compared; at most 1000 */
  double largest_error; /**< largest difference of an output at these rows, over its value [-] */
} sw_table_evidence;

/** Version of the library, "0.1.0"; never freed. */
SW_API const char* sw_version(void);

/** The commands as a JSON array of objects with name, summary, takes ("nothing", "drive" or "drive
 * or nothing"), options (names) and documents (names). */
SW_API sw_error* sw_commands(sw_text* json);

/** Reads a drive from TOML text of at most 1 MiB.
 *  @param text         TOML, at most 1 MiB
 *  @param name         name of the text in messages
 *  @param attachments  may be NULL
 *  @param drive        the drive; the caller frees it by sw_drive_free */
SW_API sw_error* sw_read(sw_text text, sw_text name, const sw_attachments* attachments,
                         sw_drive** drive);
/** Reads a drive from a source; otherwise as sw_read. */
SW_API sw_error* sw_read_from(sw_source source, sw_text name, const sw_attachments* attachments,
                              sw_drive** drive);

/** The fields of a drive as JSON, with those that its text left out and that have a fixed default.
 *  Quantities are text in SI units, "0.002 m"; `provenance.input` of a result has the same form. */
SW_API sw_error* sw_drive_fields(const sw_drive* drive, sw_text* json);

/** Sets one field, crack or section in the TOML text of a drive, and keeps everything else.
 *  @param text    TOML of the drive, at most 1 MiB
 *  @param path    "output_shaft.crack[0].depth"; "[+]" adds an element
 *  @param value   TOML as behind `=`, at most 1 MiB; NULL removes the present value
 *  @param edited  the new text; the caller frees it */
SW_API sw_error* sw_edit(sw_text text, sw_text path, const sw_text* value, sw_text* edited);

/** Runs a command.
 *  @param drive     may be NULL for a command without a drive
 *  @param command   "stiffness"
 *  @param options   JSON object, {"method": "corrected"}; empty: no option
 *  @param texts     n_texts texts that options name; may be NULL if n_texts is 0
 *  @param n_texts   number of texts; 0: none
 *  @param progress  may be NULL
 *  @param answer    what the command answered; the caller frees it by sw_answer_free */
SW_API sw_error* sw_run(const sw_drive* drive, sw_text command, sw_text options,
                        const sw_attachment* texts, size_t n_texts, const sw_progress* progress,
                        sw_answer** answer);

/** 1 if the answer may be used, else 0; its JSON gives the reason under "unusable_because". */
SW_API int sw_answer_usable(const sw_answer* answer);
/** A document of the answer; the caller frees it.  "json" is the result with its evidence
 *  (strainwave-result/1); sw_commands lists the other names. */
SW_API sw_error* sw_answer_document(const sw_answer* answer, sw_text name, sw_text* document);
/** Writes a document of the answer into a sink. */
SW_API sw_error* sw_answer_write(const sw_answer* answer, sw_text name, const sw_sink* sink);

/** Evaluates the stiffness of a drive for each row of values.  The numbers do not depend on the
 *  number of threads.
 *  @param drive     the drive whose numbers vary; it keeps its own
 *  @param task      the rows, the outputs and the number of threads
 *  @param progress  may be NULL
 *  @param numbers   shape (n_rows, n_outputs), row after row [SI unit of the output]; 0 if the code
 *                   of the row says that it has no numbers
 *  @param codes     shape (n_rows), of sw_row_code
 *  @param faults    shape (SW_ROW_CODES): the message of the first row with each code, or an empty
 *                   text; the caller frees each; may be NULL */
SW_API sw_error* sw_batch(const sw_drive* drive, const sw_batch_task* task,
                          const sw_progress* progress, double* numbers, int* codes,
                          sw_text* faults);

/** Does what sw_batch does, and states how far tables of cracks are from single evaluations.
 *  @param drive     as of sw_batch
 *  @param task      as of sw_batch
 *  @param progress  as of sw_batch
 *  @param numbers   as of sw_batch
 *  @param codes     as of sw_batch
 *  @param faults    as of sw_batch
 *  @param tables    the largest error of the tables that the rows read; may be NULL */
SW_API sw_error* sw_batch_with_evidence(const sw_drive* drive, const sw_batch_task* task,
                                        const sw_progress* progress, double* numbers, int* codes,
                                        sw_text* faults, sw_table_evidence* tables);

/** Reason of the failure that an error reports. */
SW_API sw_code sw_error_code(const sw_error* error);
/** A part of an error, valid as long as the error; empty if the error lacks the part. */
SW_API sw_text sw_error_text(const sw_error* error, sw_error_part part);
/** Line of the fault in its file, counted from 1; 0 if unknown. */
SW_API size_t sw_error_line(const sw_error* error);
/** Column of the fault in its line, counted from 1; 0 if unknown. */
SW_API size_t sw_error_column(const sw_error* error);

/** Frees a drive.  NULL may be passed. */
SW_API void sw_drive_free(sw_drive* drive);
/** Frees an answer.  NULL may be passed. */
SW_API void sw_answer_free(sw_answer* answer);
/** Frees an error.  NULL may be passed. */
SW_API void sw_error_free(sw_error* error);
/** Frees a text that the library returned for the caller to free.  An empty text may be passed. */
SW_API void sw_text_free(sw_text text);

#ifdef __cplusplus
}
#endif

/* NOLINTEND(modernize-use-using,readability-identifier-naming) */

#endif
